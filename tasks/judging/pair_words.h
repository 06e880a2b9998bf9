// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_pair.h"

namespace cradle {

/// In what circles 1 and 2 of \p own meet at other moments than those of \p right.
[[nodiscard]] std::vector<LawDeviation>
contactDeviations(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

/// In what they answer a hit otherwise: its direction and parts, then masses, then e.
[[nodiscard]] std::vector<LawDeviation>
responseDeviations(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

} // namespace cradle
