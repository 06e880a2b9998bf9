// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/ground.h"

namespace cradle {

/// That circles 1 and 2, which come to walls in the same step, are not both turned in it, though
/// each is where it comes alone; nothing where \p right, another program, does not turn both.
[[nodiscard]] std::optional<LawDeviation> wallsTogether(const QString &program,
                                                        const QString &right, const Ground &ground);

} // namespace cradle
