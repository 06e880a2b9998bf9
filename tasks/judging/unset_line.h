// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_lines.h"
#include "tasks/script/assignment.h"

namespace cradle {

/// Where a value is to be set that nothing sets before the first step: the line that sets it twice
/// for one other circle, or the head of the loop that leaves this one out; on_load, if it is set
/// for none.
/// \param made  what the program assigned before the first step
/// \return 0 if that is not known
[[nodiscard]] int unsetLine(const ProgramLines &program, const std::vector<Assignment> &made,
                            Assignment::Field field);

} // namespace cradle
