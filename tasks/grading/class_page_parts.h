// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_summary.h"

namespace cradle {

// The sections of class.html, appended to it in their order.

/// The steps as heads of columns, without what all their ids begin with.
[[nodiscard]] QString headCells(const std::vector<ClassSummary::Step> &steps);

/// A bar for every step: how many pass, do not, handed in nothing.
void writeStand(QString &html, const ClassSummary &summary);
/// Aspects × steps, and for every step what was found with an example of each.
void writeMisunderstandings(QString &html, const ClassSummary &summary);
/// Those that nobody or everybody passes.
void writeChecks(QString &html, const ClassSummary &summary);
/// Checks and minutes of those whose history was handed in.
void writeEffort(QString &html, const ClassSummary &summary);
/// Programs that share much.
void writeAlike(QString &html, const ClassSummary &summary);
/// Students × steps.
void writeWho(QString &html, const ClassSummary &summary);

} // namespace cradle
