// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_lines.h"

namespace cradle {

/// The first line before the first step that gives what \p line writes down a value of its own, not
/// that of a circle: numbers, or what it works out of the circle's.
/// \param isPosition  \p line writes down a place, not a velocity
/// \return 0 if there is none, or several far from each other
[[nodiscard]] int begunLine(const ProgramLines &program, int line, bool isPosition);

} // namespace cradle
