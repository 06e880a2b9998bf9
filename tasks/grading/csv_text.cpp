// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/csv_text.h"

#include "tasks/text/plain_text.h"

#include <QRegularExpression>

namespace cradle {

namespace {

/// Full width signs count as formulas, too, where East Asian input is usual.
const QString formulaSigns = QStringLiteral("=+\\-@\uFF1D\uFF0B\uFF0D\uFF20");

/// Puts a ' before what a spreadsheet would take for a formula: in front, but for a number below
/// zero, and behind each ; which begins a new cell where a comma stands in numbers.
QString harmless(QString text)
{
    static const QRegularExpression number(QStringLiteral("^\\s*-[0-9]+(\\.[0-9]+)?\\s*$"));
    static const QRegularExpression front(QStringLiteral("^\\s*([%1])").arg(formulaSigns));
    static const QRegularExpression behind(QStringLiteral("(;[\\s\"]*)([%1])").arg(formulaSigns));
    if (!number.match(text).hasMatch())
        text.replace(front, QStringLiteral("'\\1"));
    return text.replace(behind, QStringLiteral("\\1'\\2"));
}

QString fieldOf(const QString &value, bool quoted)
{
    // The leading spaces of Canvas's "Points Possible" stay; tabs and line ends do not.
    QString text = printable(value);
    for (QChar &letter : text) {
        if (letter.isSpace())
            letter = QLatin1Char(' ');
    }
    text = harmless(std::move(text));
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
