// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_results.h"

namespace cradle {

/// students/ID.html: what a student reads about all their steps: verdicts and points, what was
/// found with the line and the moment, remarks. It holds nothing of anybody else, and needs nothing
/// but itself, so that it can be mailed or published.
[[nodiscard]] QByteArray studentPage(const StudentResult &student, const Lab &lab,
                                     const ClassFacts &facts);

} // namespace cradle
