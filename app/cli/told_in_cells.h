// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/lab_report.h"

namespace cradle::cli {

/// makeLabReport() in processes that can only compute, see Lockdown: the programs may be anybody's.
/// A step whose process came to no end is told as stopped, with the reason.
[[nodiscard]] LabReport reportFromCells(const Lab &lab, const StudentWork &work, qint64 seed,
                                        const QDateTime &when);

} // namespace cradle::cli
