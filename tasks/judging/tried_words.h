// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/occasions.h"

#include <QString>

namespace cradle {

/// Which of those that were tried came out right, no wider than they were tried: "all up to 1 s of
/// a run, none from 2.3 s on"; empty where it is not known what divides them.
[[nodiscard]] QString triedPhrase(const Condition &condition);

/// "Of 14 tries, early and late, here and there, 8 came out right: all up to 1 s of a run, none
/// from 2.3 s on."
[[nodiscard]] QString triesTold(const std::vector<Occasion> &tries);
/// The same of those that were answered, right or wrong.
[[nodiscard]] QString answersTold(const std::vector<Occasion> &tries);

} // namespace cradle
