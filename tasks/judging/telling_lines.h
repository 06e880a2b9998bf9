// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/program_statements.h"
#include "tasks/judging/ran_lines.h"

#include <functional>

namespace cradle {

/// The line whose text tells that it is to blame: that of a mass, of a value that is copied or
/// kept, or worked out too early, of an angle; 0 if there is none.
/// \param last  the line that last changed what is wrong
/// \param isSound  whether all that a line gives is known to be right
[[nodiscard]] int tellingLine(const LawDeviation &deviation, const ProgramLines &program,
                              const QStringList &rows, const RanLines &ran, int last,
                              const std::function<bool(int)> &isSound);

/// Those of \p lines that take e, or a copy of it; all, if none does.
[[nodiscard]] std::vector<int> withRestitution(const std::vector<int> &lines,
                                               const QStringList &rows,
                                               const ProgramLines &program);

} // namespace cradle
