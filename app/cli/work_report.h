// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/report_html.h"

namespace cradle::cli {

/// A report as PDF. The application cradle, beside this program, prints it: it knows fonts, and
/// needs no display for that.
/// \return an error if there is none, or if it fails
Result<QByteArray> printedReport(const LabReport &report, const QString &language);

} // namespace cradle::cli
