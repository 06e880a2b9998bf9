// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/ending_page.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct EndingText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

constexpr int perRow = 6;
constexpr int pictureSize = 124; ///< px
constexpr std::size_t mostHard = 5;

QString paragraph(const QString &text)
{
    return QStringLiteral("<p>%1</p>\n").arg(text.toHtmlEscaped());
}

QString heading(const QString &text)
{
    return QStringLiteral("<h3>%1</h3>\n").arg(text.toHtmlEscaped());
}

QString strip(const LabReport &report, std::vector<QByteArray> &drawings)
{
    QString cells;
    int count = 0;
    for (const StepReport &step : report.steps) {
        if (step.scene.isEmpty())
            continue;
        if (count % perRow == 0)
            cells += count == 0 ? QStringLiteral("<tr>") : QStringLiteral("</tr>\n<tr>");
        cells += QStringLiteral("<td align=\"center\"><img src=\"drawing:%1\" width=\"%2\" "
                                "height=\"%2\"><br><small>%3%4</small></td>")
                     .arg(drawings.size())
                     .arg(pictureSize)
                     .arg(step.id.toHtmlEscaped(),
                          step.verdict == StepVerdict::Passed ? QStringLiteral(" ✓") : QString());
        drawings.push_back(step.scene);
        ++count;
    }
    return count == 0 ? QString()
                      : QStringLiteral("<table cellspacing=\"4\">%1</tr></table>\n").arg(cells);
}

/// The steps with the most checks that did not pass.
QString hardSteps(const LabReport &report)
{
    std::vector<const StepReport *> hard;
    for (const StepReport &step : report.steps) {
        if (!step.met.empty() || step.attempts > 1)
            hard.push_back(&step);
    }
    std::stable_sort(hard.begin(), hard.end(), [](const StepReport *a, const StepReport *b) {
        return a->attempts > b->attempts;
    });
    hard.resize(std::min(hard.size(), mostHard));
    QString items;
    for (const StepReport *step : hard) {
        QString found;
        for (const StepReport::Met &met : step->met)
            found += (found.isEmpty() ? QStringLiteral(". ") : QStringLiteral("; ")) + met.headline;
        items += QStringLiteral("<li><b>%1</b> – %2%3</li>\n")
                     .arg(step->title.toHtmlEscaped(),
                          EndingText::tr("Checks: %1").arg(step->attempts).toHtmlEscaped(),
                          found.toHtmlEscaped());
    }
    return items.isEmpty() ? QString() : QStringLiteral("<ul>\n%1</ul>\n").arg(items);
}

} // namespace

LabReportPage endingPage(const LabReport &report, bool finished)
{
    LabReportPage page;
    // Who goes to the last step at once has written a part of it.
    const bool all = finished && report.passedCount() == static_cast<int>(report.steps.size());
    page.html =
        QStringLiteral("<h2>%1</h2>\n")
            .arg((all ? EndingText::tr("You have written a physics engine") : report.labTitle)
                     .toHtmlEscaped());
    page.html += paragraph(EndingText::tr("%1 of %2 steps pass, judged anew a moment ago.")
                               .arg(report.passedCount())
                               .arg(report.steps.size()));
    page.html += strip(report, page.drawings);
    if (const QString hard = hardSteps(report); !hard.isEmpty())
        page.html += heading(EndingText::tr("What took the most checks")) + hard;
    if (!report.energies.isEmpty()) {
        page.html += heading(EndingText::tr("The energy of all runs"));
        page.html +=
            QStringLiteral("<p><img src=\"drawing:%1\" width=\"640\" height=\"320\"></p>\n")
                .arg(page.drawings.size());
        page.drawings.push_back(report.energies);
    }
    return page;
}

} // namespace cradle
