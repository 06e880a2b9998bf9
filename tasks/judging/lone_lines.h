// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/program_statements.h"

namespace cradle {

/// Where walls let circles through: the line that asks whether two lengths are the same, which a
/// step hardly ever meets, or the last that asks about walls where other circles alone are given to
/// what asks; 0 if there is none.
[[nodiscard]] int lineOfMissingWall(const LawDeviation &deviation, const ProgramLines &program,
                                    const QStringList &rows);

/// The only line that names the wall of `square` at which it shows, and no other: in a question, a
/// call or a table. 0 if there is none, or several.
[[nodiscard]] int lineOfWall(const LawDeviation &deviation, const ProgramLines &program);

/// The only line that asks whether two lengths are equal, of circles or to a wall; 0 if there is
/// none, or several.
[[nodiscard]] int equalityLine(const ProgramLines &program, const QStringList &rows);

} // namespace cradle
