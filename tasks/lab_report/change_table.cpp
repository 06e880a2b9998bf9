// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/change_table.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <utility>

namespace cradle {

namespace {

struct PageText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

constexpr std::size_t mostChangedLines = 1500; ///< of a step's program; the whole lab has 300

QString rowOf(const DiffLine &line)
{
    const bool added = line.kind == DiffLine::Kind::Added;
    const bool removed = line.kind == DiffLine::Kind::Removed;
    QString text = line.text.toHtmlEscaped();
    // Indentation must stay, also where white-space is not heeded.
    static const QRegularExpression indent(QStringLiteral("^\\s+"));
    if (const auto match = indent.match(text); match.hasMatch()) {
        const QString spaces = QString(
            match.captured().replace(QLatin1Char('\t'), QLatin1String("    ")).size(), QChar::Nbsp);
        text = spaces + text.mid(match.capturedLength());
    }
    return QStringLiteral("<tr class=\"%1\"><td class=\"number\" width=\"28\">%2</td>"
                          "<td width=\"12\">%3</td><td>%4</td></tr>\n")
        .arg(added     ? QStringLiteral("added")
             : removed ? QStringLiteral("removed")
                       : QStringLiteral("same"),
             line.after > 0 ? QString::number(line.after) : QString(),
             added     ? QStringLiteral("+")
             : removed ? QStringLiteral("−")
                       : QString(),
             text);
}

} // namespace

QString changeTable(const std::vector<DiffHunk> &change)
{
    QString rows;
    bool first = true;
    std::size_t left = mostChangedLines;
    for (const DiffHunk &hunk : change) {
        if (hunk.lines.size() > left) {
            rows += QStringLiteral("<tr><td></td><td></td><td>%1</td></tr>\n")
                        .arg(PageText::tr("… and more, which no page holds.").toHtmlEscaped());
            break;
        }
        left -= hunk.lines.size();
        if (!std::exchange(first, false))
            rows += QStringLiteral("<tr><td class=\"number\">⋮</td><td></td><td></td></tr>\n");
        for (const DiffLine &line : hunk.lines)
            rows += rowOf(line);
    }
    return QStringLiteral("<table class=\"code\" cellspacing=\"0\" cellpadding=\"1\" "
                          "width=\"100%\">\n%1</table>")
        .arg(rows);
}

} // namespace cradle
