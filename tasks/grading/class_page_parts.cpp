// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_page_parts.h"

#include "tasks/grading/page.h"

#include <QCoreApplication>
#include <QLocale>
#include <QUrl>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

struct PartsText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr double barWidth = 640.0; ///< px
constexpr double barStart = 300.0; ///< px
constexpr double barRow = 26.0;    ///< px

/// What stands in front of all of them, so that "L42T1" becomes "T1"; a whole part stays.
qsizetype commonPrefix(const std::vector<ClassSummary::Step> &steps)
{
    if (steps.size() < 2)
        return 0;
    qsizetype length = steps.front().id.size();
    for (const ClassSummary::Step &step : steps) {
        qsizetype same = 0;
        while (same < std::min(length, step.id.size() - 1)
               && step.id[same] == steps.front().id[same])
            ++same;
        length = same;
    }
    // Letters of the last part belong to it: "L42" + "T1", not "L42T" + "1".
    while (length > 0 && steps.front().id[length - 1].isLetter())
        --length;
    return length;
}

template <typename Value>
QString medianText(std::vector<Value> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const auto upper = static_cast<double>(values[half]);
    const auto lower = static_cast<double>(values[values.size() % 2 == 1 ? half : half - 1]);
    return countText(std::round(5.0 * (lower + upper)) / 10.0);
}

const char *signOf(StepResult::Status status)
{
    switch (status) {
    case StepResult::Status::Passed:
        return "<td class=p>✓";
    case StepResult::Status::Failed:
        return "<td class=f>○";
    case StepResult::Status::NotGraded:
        return "<td class=n>?";
    case StepResult::Status::Missing:
        break;
    }
    return "<td class=m>·";
}

} // namespace

QString headCells(const std::vector<ClassSummary::Step> &steps)
{
    const qsizetype prefix = commonPrefix(steps);
    QString cells;
    for (const ClassSummary::Step &step : steps)
        cells += QStringLiteral("<th scope=\"col\" title=\"%1\">%2</th>")
                     .arg(escaped(step.title), escaped(step.id.mid(prefix)));
    return cells;
}

void writeStand(QString &html, const ClassSummary &summary)
{
    if (summary.rows().empty())
        return;
    html += heading(PartsText::tr("Where the class stands"));
    const auto all = static_cast<double>(summary.rows().size());
    const double height = barRow * static_cast<double>(summary.steps().size());
    const auto width = static_cast<int>(barStart + barWidth);
    html += QStringLiteral("<figure class=\"stand\"><svg viewBox=\"0 0 %1 %2\" width=\"%1\" "
                           "height=\"%2\" role=\"img\">\n<title>%3</title>\n")
                .arg(QString::number(width), QString::number(height),
                     escaped(PartsText::tr("How many pass each step")));
    double y = 0.0;
    for (const ClassSummary::Step &step : summary.steps()) {
        QString title = QStringLiteral("%1 · %2").arg(step.id, step.title);
        if (title.size() > 40)
            title = title.left(39) + QStringLiteral("…");
        html += QStringLiteral("<text x=\"0\" y=\"%1\">%2</text>\n")
                    .arg(QString::number(y + 17.0), escaped(title));
        double x = barStart;
        const std::pair<const char *, int> parts[] = {
            {"p", step.passed}, {"f", step.failed}, {"n", step.notGraded}, {"m", step.missing}};
        for (const auto &[kind, count] : parts) {
            if (count == 0)
                continue;
            const double length = barWidth * count / all;
            html += QStringLiteral("<rect class=\"%1\" x=\"%2\" y=\"%3\" width=\"%4\" "
                                   "height=\"20\"/>")
                        .arg(QLatin1String(kind), QString::number(x, 'f', 1),
                             QString::number(y + 2.0), QString::number(length, 'f', 1));
            // A number that does not fit would lie over its neighbours.
            if (length >= 9.0 * static_cast<double>(QString::number(count).size()) + 4.0)
                html += QStringLiteral("<text class=\"in\" x=\"%1\" y=\"%2\">%3</text>")
                            .arg(QString::number(x + 0.5 * length, 'f', 1),
                                 QString::number(y + 16.5), QString::number(count));
            x += length;
        }
        html += QLatin1Char('\n');
        y += barRow;
    }
    html += QStringLiteral("</svg>\n<figcaption class=\"key\">");
    const std::pair<const char *, QString> key[] = {{"p", PartsText::tr("pass")},
                                                    {"f", PartsText::tr("do not pass yet")},
                                                    {"n", PartsText::tr("not graded")},
                                                    {"m", PartsText::tr("not handed in")}};
    for (const auto &[kind, text] : key)
        html += QStringLiteral("<svg width=\"12\" height=\"12\" aria-hidden=\"true\"><rect "
                               "class=\"%1\" width=\"12\" height=\"12\"/></svg> %2\n")
                    .arg(QLatin1String(kind), escaped(text));
    html += QStringLiteral("</figcaption></figure>\n");
}

void writeEffort(QString &html, const ClassSummary &summary)
{
    const bool any = std::any_of(summary.steps().begin(), summary.steps().end(),
                                 [](const auto &step) { return !step.minutes.empty(); });
    if (!any)
        return;
    html += heading(PartsText::tr("Checks and time on the way"));
    html +=
        paragraph(PartsText::tr("Of those who handed in a history, as it says itself. Minutes are "
                                "those in which the program changed, without pauses of more "
                                "than ten; who thinks on paper shows none. A history of commits "
                                "alone tells no checks."));
    html +=
        QStringLiteral("<div class=\"wide\"><table>\n<thead><tr><th>%1</th>"
                       "<th class=\"number\">%2</th><th class=\"number\">%3</th>"
                       "<th class=\"number\">%4</th><th class=\"number\">%5</th></tr></thead>\n"
                       "<tbody>\n")
            .arg(escaped(PartsText::tr("Step")), escaped(PartsText::tr("Students")),
                 escaped(PartsText::tr("Checks, median")), escaped(PartsText::tr("Checks, most")),
                 escaped(PartsText::tr("Minutes, median")));
    for (const ClassSummary::Step &step : summary.steps()) {
        if (step.minutes.empty())
            continue;
        const QString none = QStringLiteral("–");
        const auto most = std::max_element(step.attempts.begin(), step.attempts.end());
        html +=
            QStringLiteral("<tr><td>%1 · %2</td><td class=\"number\">%3</td>"
                           "<td class=\"number\">%4</td><td class=\"number\">%5</td>"
                           "<td class=\"number\">%6</td></tr>\n")
                .arg(escaped(step.id), escaped(step.title), QString::number(step.minutes.size()),
                     most == step.attempts.end() ? none : escaped(medianText(step.attempts)),
                     most == step.attempts.end() ? none : QString::number(*most),
                     escaped(medianText(step.minutes)));
    }
    html += QStringLiteral("</tbody>\n</table></div>\n");
}

void writeAlike(QString &html, const ClassSummary &summary)
{
    html += heading(PartsText::tr("Programs that are alike"));
    html += paragraph(
        PartsText::tr("Compared token by token, whatever their names, comments and order "
                      "(winnowing). What the lab gives is left out, and so is what more "
                      "than %1 students share. There are many good reasons for programs to be "
                      "alike: working together where that is allowed, the same book, the same "
                      "idea. A pair below proves nothing; read both, and ask.")
            .arg(summary.commonFrom()));
    if (summary.alike().empty()) {
        html += paragraph(PartsText::tr("There are none."));
        return;
    }
    for (const ClassSummary::Alike &pair : summary.alike()) {
        const QString part = QLocale().toString(100.0 * pair.part, 'f', 0);
        html += QStringLiteral("<details>\n<summary>%1 – %2 <span class=\"muted\">%3</span>"
                               "</summary>\n<div class=\"pair\">\n")
                    .arg(escapedName(pair.first), escapedName(pair.second),
                         escaped(PartsText::tr("share %1 % of what the one with less has of their "
                                               "own")
                                     .arg(part)));
        const std::array<QString, 3> sides[] = {{pair.first, pair.firstTask, pair.firstCode},
                                                {pair.second, pair.secondTask, pair.secondCode}};
        for (const auto &[name, task, code] : sides)
            html += QStringLiteral("<div><h3>%1 · %2</h3>\n<pre>%3</pre></div>\n")
                        .arg(escapedName(name), escaped(task), escaped(code));
        html += QStringLiteral("</div>\n</details>\n");
    }
}

void writeWho(QString &html, const ClassSummary &summary)
{
    if (summary.rows().empty())
        return;
    html += heading(PartsText::tr("Who is where"));
    html +=
        paragraph(PartsText::tr("✓ passes, ○ does not pass yet, · not handed in, ? not graded"));
    html += QStringLiteral("<div class=\"wide\"><table class=\"who\">\n<thead><tr>"
                           "<th scope=\"col\">%1</th>%2<th scope=\"col\">%3</th>"
                           "<th scope=\"col\">%4</th></tr></thead>\n<tbody>\n")
                .arg(escaped(PartsText::tr("Student")), headCells(summary.steps()),
                     escaped(PartsText::tr("passed")), escaped(PartsText::tr("points")));
    // Short, for there may be thousands: HTML closes cells by itself.
    for (const ClassSummary::Row &row : summary.rows()) {
        html +=
            QStringLiteral("<tr><th scope=row><a href=\"students/%1.html\">%2</a>")
                .arg(QString::fromLatin1(QUrl::toPercentEncoding(row.id)), escapedName(row.name));
        for (const StepResult::Status status : row.steps)
            html += QString::fromUtf8(signOf(status));
        html += QStringLiteral("<td class=number>%1<td class=number>%2\n")
                    .arg(QString::number(row.passed), row.points.earned
                                                          ? escaped(countText(*row.points.earned))
                                                          : QStringLiteral("–"));
    }
    html += QStringLiteral("</tbody>\n</table></div>\n");
}

} // namespace cradle
