// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/program_functions.h"
#include "tasks/judging/ran_lines.h"

namespace cradle {

/// Lines at fault on the other side of a call, and where something stands for a value that a line
/// only takes. All are 0 where none is known.

/// Where a question about a distance only asks what one function of the program works out: its only
/// line that returns something.
[[nodiscard]] int askedOfFunction(const LawDeviation &deviation, const ProgramLines &program,
                                  int question);

/// Where \p line stands in a function that moves one circle as it should and another, the one of
/// the deviation, not: the first line that calls it for that one by its name.
[[nodiscard]] int callForOne(const LawDeviation &deviation, const ProgramLines &program, int line);

/// Where \p line takes another timestep than that of the step: the only line that gives it.
[[nodiscard]] int timestepGiven(const ProgramLines &program, int line);

/// Where a wall leaves the velocity as it was: the first line of those that only the hit needs that
/// turns a variable round, if none of them sets a velocity; the line that sets the place, if the
/// step sets no velocity at all.
[[nodiscard]] int unwrittenTurn(const LawDeviation &deviation, const ProgramLines &program,
                                const RanLines &ran);

} // namespace cradle
