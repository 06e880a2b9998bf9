// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_folder.h"

namespace cradle {

/// An id that any disk takes. Where letters had to go, a piece of the hash of all of them keeps it
/// unlike others, whoever else is in the class.
[[nodiscard]] QString studentIdFrom(const QString &name);

/// Gives the students that were found what \p roster knows of them, by folder, id, number or name,
/// and says who is missing and who is not in it.
void applyRoster(ClassFolder &found, const std::vector<RosterRow> &roster);

} // namespace cradle
