// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_page_parts.h"

#include "tasks/grading/page.h"
#include "tasks/lab_report/markdown_html.h"

#include <QCoreApplication>
#include <QLocale>
#include <QUrl>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

struct ClassText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr int fewestForVerdict = 3;    ///< students; of fewer nothing is said about a check
constexpr std::size_t mostListed = 12; ///< misunderstandings of a step
constexpr double leastHeat = 12.0;     ///< %: of one student among many
constexpr double mostHeat = 70.0;      ///< %: text on it can still be read
constexpr double barWidth = 640.0;     ///< px
constexpr double barStart = 300.0;     ///< px
constexpr double barRow = 26.0;        ///< px

/// What stands in front of all of them, so that "L42T1" becomes "T1"; a whole part stays.
qsizetype commonPrefix(const std::vector<ClassSummary::Step> &steps)
{
    if (steps.size() < 2)
        return 0;
    qsizetype length = steps.front().id.size() - 1;
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

QString headCells(const std::vector<ClassSummary::Step> &steps)
{
    const qsizetype prefix = commonPrefix(steps);
    QString cells;
    for (const ClassSummary::Step &step : steps)
        cells += QStringLiteral("<th scope=\"col\" title=\"%1\">%2</th>")
                     .arg(escaped(step.title), escaped(step.id.mid(prefix)));
    return cells;
}

QString aspectText(Aspect aspect)
{
    switch (aspect) {
    case Aspect::Start:
        return ClassText::tr("How it starts");
    case Aspect::Motion:
        return ClassText::tr("Free motion");
    case Aspect::Walls:
        return ClassText::tr("Walls");
    case Aspect::Contact:
        return ClassText::tr("When two touch");
    case Aspect::Response:
        return ClassText::tr("What a hit does");
    case Aspect::Course:
        break;
    }
    return ClassText::tr("In the long run");
}

QString heatCell(int count, int judged)
{
    if (count == 0)
        return QStringLiteral("<td></td>");
    const double share = std::min(1.0, static_cast<double>(count) / std::max(1, judged));
    const double part = leastHeat + (mostHeat - leastHeat) * share;
    return QStringLiteral("<td style=\"--part: %1%\">%2</td>").arg(part, 0, 'f', 1).arg(count);
}

void writeHeat(QString &html, const ClassSummary &summary)
{
    html += QStringLiteral("<div class=\"wide\"><table class=\"heat\">\n<thead><tr>"
                           "<th scope=\"col\">%1</th>%2</tr></thead>\n<tbody>\n")
                .arg(escaped(ClassText::tr("Students with a finding")), headCells(summary.steps()));
    const auto row = [&](const QString &name, auto countOf) {
        html += QStringLiteral("<tr><th scope=\"row\">%1</th>").arg(escaped(name));
        for (const ClassSummary::Step &step : summary.steps())
            html += heatCell(countOf(step), step.passed + step.failed);
        html += QStringLiteral("</tr>\n");
    };
    for (const Aspect aspect : {Aspect::Start, Aspect::Motion, Aspect::Walls, Aspect::Contact,
                                Aspect::Response, Aspect::Course})
        row(aspectText(aspect), [&](const ClassSummary::Step &step) {
            const auto found = step.aspects.find(aspect);
            return found == step.aspects.end() ? 0 : found->second;
        });
    row(ClassText::tr("The program stops"), [](const auto &step) { return step.stopped; });
    html += QStringLiteral("</tbody>\n</table></div>\n");
}

QString example(const ClassSummary::Misunderstanding &met)
{
    QString html = QStringLiteral("<details><summary>%1</summary>\n%2")
                       .arg(escaped(ClassText::tr("an example")), markdownHtml(met.message));
    if (met.codeLine > 0) {
        const QStringList lines = met.code.split(QLatin1Char('\n'));
        html += QStringLiteral("<pre class=\"program\">");
        for (qsizetype i = 0; i < lines.size(); ++i)
            html +=
                QStringLiteral("<span%1>%2</span>")
                    .arg(i + 1 == met.codeLine ? QStringLiteral(" class=\"marked\"") : QString(),
                         escaped(lines[i].left(200)));
        html += QStringLiteral("</pre>\n");
    }
    return html + QStringLiteral("</details>\n");
}

void writeMet(QString &html, const ClassSummary::Step &step, bool open)
{
    std::vector<const ClassSummary::Misunderstanding *> all;
    for (const auto &[key, met] : step.misunderstandings)
        all.push_back(&met);
    std::stable_sort(all.begin(), all.end(),
                     [](const auto *a, const auto *b) { return a->count > b->count; });
    html +=
        QStringLiteral("<details class=\"printed\"%1>\n<summary>%2 · %3 <span "
                       "class=\"muted\">%4</span></summary>"
                       "\n<ul class=\"met\">\n")
            .arg(open ? QStringLiteral(" open") : QString(), escaped(step.id), escaped(step.title),
                 escaped(ClassText::tr("%1 of %2 do not pass")
                             .arg(step.failed)
                             .arg(step.passed + step.failed)));
    for (std::size_t i = 0; i < std::min(all.size(), mostListed); ++i)
        html +=
            QStringLiteral("<li><span class=\"count\">%1 ×</span>%2\n%3</li>\n")
                .arg(QString::number(all[i]->count), escaped(all[i]->headline), example(*all[i]));
    html += QStringLiteral("</ul>\n");
    if (all.size() > mostListed)
        html += paragraph(ClassText::tr("And %1 more.").arg(all.size() - mostListed));
    html += QStringLiteral("</details>\n");
}

template <typename Value>
QString medianText(std::vector<Value> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const auto upper = static_cast<double>(values[half]);
    const auto lower = static_cast<double>(values[values.size() % 2 == 1 ? half : half - 1]);
    return QLocale().toString(std::round(5.0 * (lower + upper)) / 10.0, 'g', 8);
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

QString heading(const QString &text)
{
    return QStringLiteral("<h2>%1</h2>\n").arg(escaped(text));
}

QString paragraph(const QString &text)
{
    return QStringLiteral("<p>%1</p>\n").arg(escaped(text));
}

void writeStand(QString &html, const ClassSummary &summary)
{
    if (summary.rows().empty())
        return;
    html += heading(ClassText::tr("Where the class stands"));
    const auto all = static_cast<double>(summary.rows().size());
    const double height = barRow * static_cast<double>(summary.steps().size());
    const auto width = static_cast<int>(barStart + barWidth);
    html += QStringLiteral("<figure class=\"stand\"><svg viewBox=\"0 0 %1 %2\" width=\"%1\" "
                           "height=\"%2\" role=\"img\">\n<title>%3</title>\n")
                .arg(QString::number(width), QString::number(height),
                     escaped(ClassText::tr("How many pass each step")));
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
    const std::pair<const char *, QString> key[] = {{"p", ClassText::tr("pass")},
                                                    {"f", ClassText::tr("do not pass yet")},
                                                    {"n", ClassText::tr("not graded")},
                                                    {"m", ClassText::tr("not handed in")}};
    for (const auto &[kind, text] : key)
        html += QStringLiteral("<svg width=\"12\" height=\"12\" aria-hidden=\"true\"><rect "
                               "class=\"%1\" width=\"12\" height=\"12\"/></svg> %2\n")
                    .arg(QLatin1String(kind), escaped(text));
    html += QStringLiteral("</figcaption></figure>\n");
}

void writeMisunderstandings(QString &html, const ClassSummary &summary)
{
    html += heading(ClassText::tr("What the class misunderstood"));
    const bool any =
        std::any_of(summary.steps().begin(), summary.steps().end(), [](const auto &step) {
            return !step.misunderstandings.empty() || step.stopped > 0;
        });
    if (!any) {
        html += paragraph(ClassText::tr("Nothing was found."));
        return;
    }
    html +=
        paragraph(ClassText::tr("How many students have a finding of that sort in that step; "
                                "the stronger the colour, the larger their part of those who were "
                                "judged. "
                                "The examples are of one student each, without names and "
                                "comments."));
    writeHeat(html, summary);
    bool open = true;
    for (const ClassSummary::Step &step : summary.steps()) {
        if (!step.misunderstandings.empty())
            writeMet(html, step, std::exchange(open, false));
    }
}

void writeChecks(QString &html, const ClassSummary &summary)
{
    QString nobody;
    QString everybody;
    for (const ClassSummary::Step &step : summary.steps()) {
        for (const ClassSummary::Check &check : step.checks) {
            const int judged = check.passed + check.failed;
            if (judged < fewestForVerdict || (check.passed > 0 && check.failed > 0))
                continue;
            (check.passed == 0 ? nobody : everybody) +=
                QStringLiteral("<li>%1: %2 <span class=\"muted\">(%3)</span></li>\n")
                    .arg(escaped(step.id), escaped(check.title), QString::number(judged));
        }
    }
    if (nobody.isEmpty() && everybody.isEmpty())
        return;
    html += heading(ClassText::tr("Checks that tell nobody apart"));
    html += paragraph(ClassText::tr("In brackets: how many were judged by it."));
    if (!nobody.isEmpty())
        html += QStringLiteral("<h3>%1</h3>\n<ul>\n%2</ul>\n")
                    .arg(escaped(ClassText::tr("Nobody passes")), nobody);
    if (!everybody.isEmpty())
        html += QStringLiteral("<details class=\"printed\">\n<summary>%1</summary>\n<ul>\n%2</ul>\n"
                               "</details>\n")
                    .arg(escaped(ClassText::tr("Everybody passes")), everybody);
}

void writeEffort(QString &html, const ClassSummary &summary)
{
    const bool any = std::any_of(summary.steps().begin(), summary.steps().end(),
                                 [](const auto &step) { return !step.minutes.empty(); });
    if (!any)
        return;
    html += heading(ClassText::tr("Checks and time on the way"));
    html +=
        paragraph(ClassText::tr("Of those who handed in a history, as it says itself. Minutes are "
                                "those in which the program changed, without pauses of more "
                                "than ten; who thinks on paper shows none. A history of commits "
                                "alone tells no checks."));
    html +=
        QStringLiteral("<div class=\"wide\"><table>\n<thead><tr><th>%1</th>"
                       "<th class=\"number\">%2</th><th class=\"number\">%3</th>"
                       "<th class=\"number\">%4</th><th class=\"number\">%5</th></tr></thead>\n"
                       "<tbody>\n")
            .arg(escaped(ClassText::tr("Step")), escaped(ClassText::tr("Students")),
                 escaped(ClassText::tr("Checks, median")), escaped(ClassText::tr("Checks, most")),
                 escaped(ClassText::tr("Minutes, median")));
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
    html += heading(ClassText::tr("Programs that are alike"));
    html += paragraph(
        ClassText::tr("Compared token by token, whatever their names, comments and order "
                      "(winnowing). What the lab gives is left out, and so is what more "
                      "than %1 students share. There are many good reasons for programs to be "
                      "alike: working together where that is allowed, the same book, the same "
                      "idea. A pair below proves nothing; read both, and ask.")
            .arg(summary.commonFrom()));
    if (summary.alike().empty()) {
        html += paragraph(ClassText::tr("There are none."));
        return;
    }
    for (const ClassSummary::Alike &pair : summary.alike()) {
        const QString part = QLocale().toString(100.0 * pair.part, 'f', 0);
        html += QStringLiteral("<details>\n<summary>%1 – %2 <span class=\"muted\">%3</span>"
                               "</summary>\n<div class=\"pair\">\n")
                    .arg(escapedName(pair.first), escapedName(pair.second),
                         escaped(ClassText::tr("share %1 % of what the one with less has of their "
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
    html += heading(ClassText::tr("Who is where"));
    html +=
        paragraph(ClassText::tr("✓ passes, ○ does not pass yet, · not handed in, ? not graded"));
    html += QStringLiteral("<div class=\"wide\"><table class=\"who\">\n<thead><tr>"
                           "<th scope=\"col\">%1</th>%2<th scope=\"col\">%3</th>"
                           "<th scope=\"col\">%4</th></tr></thead>\n<tbody>\n")
                .arg(escaped(ClassText::tr("Student")), headCells(summary.steps()),
                     escaped(ClassText::tr("passed")), escaped(ClassText::tr("points")));
    // Short, for there may be thousands: HTML closes cells by itself.
    for (const ClassSummary::Row &row : summary.rows()) {
        html +=
            QStringLiteral("<tr><th scope=row><a href=\"students/%1.html\">%2</a>")
                .arg(QString::fromLatin1(QUrl::toPercentEncoding(row.id)), escapedName(row.name));
        for (const StepResult::Status status : row.steps)
            html += QString::fromUtf8(signOf(status));
        html += QStringLiteral("<td class=number>%1<td class=number>%2\n")
                    .arg(QString::number(row.passed),
                         row.points.earned ? escaped(QLocale().toString(*row.points.earned, 'g', 8))
                                           : QStringLiteral("–"));
    }
    html += QStringLiteral("</tbody>\n</table></div>\n");
}

} // namespace cradle
