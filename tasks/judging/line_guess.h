// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"

namespace cradle {

/// Where a teacher would point first, if no change is proven to mend a program: among the lines
/// that run at the moment and not in free flight, the question before them where something is
/// answered at a wrong place, the formula where the answer is wrong; the line that works out a mass
/// where masses are.
/// \param last  the line of the assignment that last changed what is wrong; 0 if unknown
/// \return  \p last if there is no better one, 0 if the fault is that a line is missing
[[nodiscard]] int guessedLine(const QString &program, const LawDeviation &deviation, int last);

} // namespace cradle
