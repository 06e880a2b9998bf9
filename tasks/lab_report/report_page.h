// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// A report as a page.
struct LabReportPage {
    QString html{};
    std::vector<QByteArray> drawings{}; ///< SVG, by number
};

/// Keeps a page as page.html, and its drawings as N.svg, for who prints it; and reads it back.
std::optional<Error> savePage(const LabReportPage &page, const QString &folder);
Result<LabReportPage> readPage(const QString &folder);

} // namespace cradle
