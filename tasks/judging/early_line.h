// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_lines.h"

namespace cradle {

/// The first line that works something out of a value of the scene before that is set, at the top
/// of the file or in on_load: it keeps what was there before. 0 if there is none.
/// \param fields  what such a value is called
[[nodiscard]] int earlyLine(const ProgramLines &program, const QStringList &fields);

} // namespace cradle
