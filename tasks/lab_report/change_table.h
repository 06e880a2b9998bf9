// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/text/line_diff.h"

namespace cradle {

/// What changed in a program as a table in HTML: number, sign and text of each line. It ends after
/// 1,500 lines, and says so.
[[nodiscard]] QString changeTable(const std::vector<DiffHunk> &change);

} // namespace cradle
