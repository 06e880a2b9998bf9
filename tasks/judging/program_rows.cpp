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
    static const QRegularExpression product(QStringLiteral("[*/^]"));
    static const QRegularExpression sum(QStringLiteral("[-+]"));
    return 2 * static_cast<int>(row.count(product)) + static_cast<int>(row.count(sum));
}

bool asksForWall(const QString &row)
{
    static const QRegularExpression wall(
        QStringLiteral("\\b(square|left|right|top|bottom|half_width)\\b"));
    return row.contains(wall);
}

QString withName(const QString &row, const QString &name, const QString &other)
{
    const auto isAt = [&](qsizetype at) { return at >= 0 && at < row.size() && isOfName(row[at]); };
    QString changed;
    qsizetype done = 0;
    for (qsizetype at = row.indexOf(name); at >= 0; at = row.indexOf(name, at + name.size())) {
        if (isAt(at - 1) || isAt(at + name.size()))
            continue;
        changed += row.mid(done, at - done) + other;
        done = at + name.size();
    }
    return changed + row.mid(done);
}

bool takes(const QString &row, const QString &giving)
{
    static const QRegularExpression local(QStringLiteral("^\\s*local\\s+(\\w+)\\s*="));
    const QRegularExpressionMatch match = local.match(giving);
    return match.hasMatch() && withName(row, match.captured(1), {}) != row;
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
