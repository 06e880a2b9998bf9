// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/line_at_fault.h"

namespace cradle {

/// What became of \p fault: gone, or shown by fewer scenes, with nothing new instead.
/// \param before, left  all that is said of an aspect, of the program and of the changed one
[[nodiscard]] Mending mendingOf(const LawDeviation &fault, const std::vector<LawDeviation> &before,
                                const std::vector<LawDeviation> &left);

} // namespace cradle
