// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/report_html.h"

namespace cradle::cli {

// Reports as files, in the language in force. The application cradle, beside this program, prints
// and sets formulas: it knows fonts, and needs no display for that.

/// Sets the formulas of \p report; without that application they stay plain text.
void setFormulas(LabReport &report);

/// \return PDF, or an error if there is no such application, or if it fails
Result<QByteArray> printedReport(const LabReport &report);

/// One page that needs nothing else.
[[nodiscard]] QByteArray htmlOf(const LabReport &report);

} // namespace cradle::cli
