// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/csv_text.h"

#include "tasks/text/plain_text.h"

namespace cradle {

namespace {

bool isNumber(const QString &text)
{
    bool ok = false;
    text.toDouble(&ok);
    return ok;
}

QString fieldOf(const QString &value, bool quoted)
{
    // The leading spaces of Canvas's "Points Possible" stay; tabs and line ends do not.
    QString text = printable(value);
    for (QChar &letter : text) {
        if (letter.isSpace())
            letter = QLatin1Char(' ');
    }
    const QString bare = text.trimmed();
    // Full width signs count as formulas, too, where East Asian input is usual.
    static const QString signs = QStringLiteral("=+-@\uFF1D\uFF0B\uFF0D\uFF20");
    if (!bare.isEmpty() && signs.contains(bare[0]) && !isNumber(bare))
        text = QLatin1Char('\'') + bare;
    if (quoted || text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"'))
        || text.contains(QLatin1Char(';')))
        text = QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String("\"\""))
               + QLatin1Char('"');
    return text;
}

} // namespace

QByteArray csvRow(const QStringList &fields, bool quoteAll)
{
    QStringList row;
    for (const QString &field : fields)
        row.append(fieldOf(field, quoteAll));
    return row.join(QLatin1Char(',')).toUtf8() + "\r\n";
}

} // namespace cradle
