// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/report_page.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"

#include <QFile>

namespace cradle {

namespace {

constexpr qint64 mostBytes = 64 * 1024 * 1024; ///< of a page or a drawing

} // namespace

std::optional<Error> savePage(const LabReportPage &page, const QString &folder)
{
    for (std::size_t i = 0; i < page.drawings.size(); ++i) {
        if (auto error =
                writeFile(QStringLiteral("%1/%2.svg").arg(folder).arg(i), page.drawings[i]))
            return error;
    }
    return writeFile(folder + QStringLiteral("/page.html"), page.html.toUtf8());
}

Result<LabReportPage> readPage(const QString &folder)
{
    const auto html = readFile(folder + QStringLiteral("/page.html"), mostBytes);
    if (!html)
        return html.error();
    LabReportPage page{.html = QString::fromUtf8(*html)};
    for (int i = 0; QFile::exists(QStringLiteral("%1/%2.svg").arg(folder).arg(i)); ++i) {
        const auto svg = readFile(QStringLiteral("%1/%2.svg").arg(folder).arg(i), mostBytes);
        if (!svg)
            return svg.error();
        page.drawings.push_back(*svg);
    }
    return page;
}

} // namespace cradle
