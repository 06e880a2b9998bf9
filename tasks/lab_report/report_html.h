// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/lab_report.h"
#include "tasks/lab_report/report_page.h"

namespace cradle {

/// How drawings stand in the report.
enum class Drawings {
    Inside,  ///< as SVG in the page: one file that needs nothing else
    Numbered ///< <img src="drawing:N">, N from 0, for who draws them: see LabReportPage::drawings
};

/// The report in the language in force, in light colours.
[[nodiscard]] LabReportPage labReportPage(const LabReport &report, Drawings drawings,
                                          const QString &language);

/// The lab, and whose report it is if that is known.
[[nodiscard]] QString titleOf(const LabReport &report);

} // namespace cradle
