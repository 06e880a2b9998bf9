// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_page_parts.h"

#include "tasks/grading/page.h"
#include "tasks/lab_report/markdown_html.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

struct FindingsText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr int fewestForVerdict = 3;    ///< students; of fewer nothing is said about a check
constexpr std::size_t mostListed = 12; ///< misunderstandings of a step
constexpr double leastHeat = 12.0;     ///< %: of one student among many
constexpr double mostHeat = 70.0;      ///< %: text on it can still be read

QString heatCell(int count, int judged)
{
    if (count == 0)
        return QStringLiteral("<td></td>");
    const double share = std::min(1.0, static_cast<double>(count) / std::max(1, judged));
    const double part = leastHeat + (mostHeat - leastHeat) * share;
    return QStringLiteral("<td style=\"--part: %1%\">%2</td>").arg(part, 0, 'f', 1).arg(count);
}

QString aspectText(Aspect aspect)
{
    switch (aspect) {
    case Aspect::Start:
        return FindingsText::tr("How it starts");
    case Aspect::Motion:
        return FindingsText::tr("Free motion");
    case Aspect::Walls:
        return FindingsText::tr("Walls");
    case Aspect::Contact:
        return FindingsText::tr("When two touch");
    case Aspect::Response:
        return FindingsText::tr("What a hit does");
    case Aspect::Course:
        break;
    }
    return FindingsText::tr("In the long run");
}

void writeHeat(QString &html, const ClassSummary &summary)
{
    html +=
        QStringLiteral("<div class=\"wide\"><table class=\"heat\">\n<thead><tr>"
                       "<th scope=\"col\">%1</th>%2</tr></thead>\n<tbody>\n")
            .arg(escaped(FindingsText::tr("Students with a finding")), headCells(summary.steps()));
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
    row(FindingsText::tr("The program stops"), [](const auto &step) { return step.stopped; });
    html += QStringLiteral("</tbody>\n</table></div>\n");
}

QString example(const ClassSummary::Misunderstanding &met)
{
    QString html = QStringLiteral("<details><summary>%1</summary>\n%2")
                       .arg(escaped(FindingsText::tr("an example")), markdownHtml(met.message));
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
                 escaped(FindingsText::tr("%1 of %2 do not pass")
                             .arg(step.failed)
                             .arg(step.passed + step.failed)));
    for (std::size_t i = 0; i < std::min(all.size(), mostListed); ++i)
        html +=
            QStringLiteral("<li><span class=\"count\">%1 ×</span>%2\n%3</li>\n")
                .arg(QString::number(all[i]->count), escaped(all[i]->headline), example(*all[i]));
    html += QStringLiteral("</ul>\n");
    if (all.size() > mostListed)
        html += paragraph(FindingsText::tr("And %1 more.").arg(all.size() - mostListed));
    html += QStringLiteral("</details>\n");
}

} // namespace

void writeMisunderstandings(QString &html, const ClassSummary &summary)
{
    html += heading(FindingsText::tr("What the class misunderstood"));
    const bool any =
        std::any_of(summary.steps().begin(), summary.steps().end(), [](const auto &step) {
            return !step.misunderstandings.empty() || step.stopped > 0;
        });
    if (!any) {
        html += paragraph(FindingsText::tr("Nothing was found."));
        return;
    }
    html += paragraph(
        FindingsText::tr("How many students have a finding of that sort in that step; "
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
    html += heading(FindingsText::tr("Checks that tell nobody apart"));
    html += paragraph(FindingsText::tr("In brackets: how many were judged by it."));
    if (!nobody.isEmpty())
        html += QStringLiteral("<h3>%1</h3>\n<ul>\n%2</ul>\n")
                    .arg(escaped(FindingsText::tr("Nobody passes")), nobody);
    if (!everybody.isEmpty())
        html += QStringLiteral("<details class=\"printed\">\n<summary>%1</summary>\n<ul>\n%2</ul>\n"
                               "</details>\n")
                    .arg(escaped(FindingsText::tr("Everybody passes")), everybody);
}

} // namespace cradle
