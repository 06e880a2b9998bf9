// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/report_page.h"

namespace cradle {

/// Prints a report with numbered drawings as PDF, A4: the drawings as vectors, fonts embedded,
/// a page number on every page.
[[nodiscard]] QByteArray printedPdf(const LabReportPage &page, const QString &title);

} // namespace cradle
