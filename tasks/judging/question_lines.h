// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/asked_values.h"
#include "tasks/judging/deviation.h"
#include "tasks/judging/program_rows.h"
#include "tasks/judging/ran_lines.h"

namespace cradle {

/// The question that leads to the first of \p special, or that is among them: of those within a
/// function such as ask for a distance, or for more than that; of a hit of two none that asks for a
/// wall. \pre \p special is not empty
[[nodiscard]] int questionOf(Suspect suspect, const std::vector<int> &special,
                             const QStringList &rows, const RanLines &ran, const RowRange &within,
                             const AskedValues &asked, bool isOfPair);

/// Where the value is worked out that a question asks, if it is one.
[[nodiscard]] int askedIn(int question, Suspect suspect, const AskedValues &asked);

/// The condition of the block in which \p line stands; 0 if there is none in its function.
[[nodiscard]] int conditionAbove(int line, const QStringList &rows, const RanLines &ran);

/// The question about two circles that no answer leads to: the last that was asked for the first
/// time, which let them go on; of those for a reach the only one. 0 if there is none.
[[nodiscard]] int unledQuestion(Suspect suspect, const QStringList &rows, const RanLines &ran,
                                const AskedValues &asked);

/// The first line that gives a value in the branch that is not taken where the question of \p line
/// has the answer \p verdict; 0 if there is no other branch.
[[nodiscard]] int avoidedLine(const ProgramLines &program, int line, bool verdict);

} // namespace cradle
