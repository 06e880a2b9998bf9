// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/lab_report.h"

namespace cradle {

/// How drawings stand in the report.
enum class Drawings {
    Inside,  ///< as SVG in the page: one file that needs nothing else
    Numbered ///< <img src="drawing:N">, N from 0, for who draws them: see LabReportPage::drawings
};

/// A report as a page, in the language in force, in light colours.
struct LabReportPage {
    QString html{};
    std::vector<QByteArray> drawings{}; ///< SVG, by number
};

/// Keeps a page as page.html, and its drawings as N.svg, for who prints it; and reads it back.
std::optional<Error> savePage(const LabReportPage &page, const QString &folder);
Result<LabReportPage> readPage(const QString &folder);

[[nodiscard]] LabReportPage labReportPage(const LabReport &report, Drawings drawings,
                                          const QString &language);

/// The lab, and whose report it is if that is known.
[[nodiscard]] QString titleOf(const LabReport &report);

} // namespace cradle
