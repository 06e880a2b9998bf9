// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/line_at_fault.h"

namespace cradle {

/// The lines that only the moment needs, then others that run at it, then those that work out what
/// circles keep, such as masses; of the first those that a teacher would look at before others.
[[nodiscard]] std::vector<int> suspectLines(const FaultQuery &query);

} // namespace cradle
