// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_rows.h"

#include <QRegularExpression>

namespace cradle {

QStringList rowsOf(const QString &program)
{
    QStringList rows = program.split(QLatin1Char('\n'));
    for (QString &row : rows)
        row = row.section(QLatin1String("--"), 0, 0);
    return rows;
}

bool compares(const QString &row)
{
    static const QRegularExpression sign(QStringLiteral("[<>]"));
    return row.contains(sign);
}

int worksOut(const QString &row)
{
    static const QRegularExpression assigns(QStringLiteral("(^|[^=<>~])=([^=]|$)|\\breturn\\b"));
    if (!row.contains(assigns) || row.contains(QLatin1String("position"))
        || row.contains(QLatin1String("sqrt")))
        return 0;
    return 2 * static_cast<int>(row.count(QRegularExpression(QStringLiteral("[*/^]"))))
           + static_cast<int>(row.count(QRegularExpression(QStringLiteral("[-+]"))));
}

bool asksForWall(const QString &row)
{
    static const QRegularExpression wall(
        QStringLiteral("\\b(square|left|right|top|bottom|half_width)\\b"));
    return row.contains(wall);
}

bool takes(const QString &row, const QString &giving)
{
    static const QRegularExpression local(QStringLiteral("^\\s*local\\s+(\\w+)\\s*="));
    const QRegularExpressionMatch match = local.match(giving);
    return match.hasMatch()
           && row.contains(QRegularExpression(QStringLiteral("\\b%1\\b").arg(match.captured(1))));
}

RowRange functionOf(const QStringList &rows, int line)
{
    static const QRegularExpression header(QStringLiteral("\\bfunction\\b"));
    static const QRegularExpression whole(QStringLiteral("\\bfunction\\b.*\\bend\\b"));
    const auto begins = [&](int at) {
        return rows[at - 1].contains(header) && !rows[at - 1].contains(whole);
    };
    RowRange lines{line, line};
    while (lines.first > 1 && !begins(lines.first))
        --lines.first;
    while (lines.last < rows.size() && !begins(lines.last + 1))
        ++lines.last;
    return lines;
}

} // namespace cradle
