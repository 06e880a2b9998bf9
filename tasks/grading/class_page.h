// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_summary.h"

namespace cradle {

/// class.html, for the teacher: who is where, what the class misunderstood (without names), checks
/// that nobody or everybody fails, time and attempts, programs that are alike, what was not graded
/// and how it all was judged. It needs nothing but itself.
[[nodiscard]] QByteArray classPage(const ClassSummary &summary, const Lab &lab,
                                   const ClassFacts &facts);

} // namespace cradle
