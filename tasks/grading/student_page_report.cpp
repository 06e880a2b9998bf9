// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/student_page_report.h"

#include "tasks/grading/page.h"
#include "tasks/grading/points.h"
#include "tasks/lab_report/lab_report.h"
#include "tasks/lab_report/markdown_html.h"
#include "tasks/text/quantity_text.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct StudentReportText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qsizetype mostLocals = 6; ///< that are told with an error

void writeMoment(QString &html, const CheckReport &report, const StepMoment &moment)
{
    const auto check =
        std::find_if(report.checks.begin(), report.checks.end(),
                     [&](const CheckOutcome &each) { return each.id == moment.check; });
    if (check == report.checks.end())
        return;
    QString caption =
        moment.scene.time > 0.0
            ? StudentReportText::tr("“%1” first goes wrong here, at %2 s.")
                  .arg(check->title, quantityText(moment.scene.time, 'f', 2))
            : StudentReportText::tr("“%1” goes wrong from the start.").arg(check->title);
    if (!check->variant.isEmpty() && check->variant != QLatin1String("preset"))
        caption += QLatin1Char(' ') + StudentReportText::tr("Scene: %1.").arg(check->variant);
    html += QStringLiteral("<figure class=\"scene\">\n%1<figcaption>%2</figcaption>\n"
                           "</figure>\n")
                .arg(QString::fromUtf8(sceneSvg(moment.scene)), escaped(caption));
}

void writeError(QString &html, const StepResult &step, const ProgramError &error)
{
    html += paragraph(error.step > 0
                          ? StudentReportText::tr("The program stopped in step %1 of a scene, at "
                                                  "%2 s.")
                                .arg(error.step)
                                .arg(quantityText(error.time, 'g', 4))
                      : error.kind == ProgramError::Kind::Syntax
                          ? StudentReportText::tr("The program does not load.")
                          : StudentReportText::tr("The program stopped before its first step."));
    html += QStringLiteral("<pre class=\"message\">%1</pre>\n")
                .arg(escaped(
                    error.line > 0
                        ? StudentReportText::tr("line %1: %2").arg(error.line).arg(error.message)
                        : error.message));
    html += codeAround(step.program, error.line);
    QStringList values;
    for (const ProgramValue &local : error.locals) {
        if (values.size() < mostLocals)
            values.append(QStringLiteral("<code>%1 = %2</code>")
                              .arg(escaped(local.name), escaped(local.value)));
    }
    if (!values.isEmpty())
        html +=
            QStringLiteral("<p>%1 %2</p>\n")
                .arg(escaped(StudentReportText::tr("There:")), values.join(QStringLiteral(", ")));
}

void writeFinding(QString &html, const StepResult &step, const Finding &finding, std::size_t index)
{
    html += QStringLiteral(
                "<details class=\"printed\"%1>\n<summary>%2</summary>\n<div class=\"finding\">\n"
                "<div>\n%3")
                .arg(index == 0 ? QStringLiteral(" open") : QString(),
                     escaped(headlineOf(finding.message)),
                     markdownHtml(belowHeadline(finding.message)));
    const QString code = codeAround(step.program, finding.line);
    if (!code.isEmpty())
        html +=
            paragraph(StudentReportText::tr("Look at line %1 of your program.").arg(finding.line));
    if (!finding.calls.empty()) {
        QStringList lines;
        for (const int line : finding.calls)
            lines.append(QString::number(line));
        html += paragraph(
            StudentReportText::tr("It is reached by the calls in line %1.").arg(spokenList(lines)),
            "muted");
    }
    html += QStringLiteral("</div>\n");
    for (const StepMoment &moment : step.moments) {
        if (moment.check == finding.check)
            writeMoment(html, *step.report, moment);
    }
    html += QStringLiteral("</div>\n%1</details>\n").arg(code);
}

void writeChecks(QString &html, const Task &task, const CheckReport &report)
{
    html += QStringLiteral("<table class=\"checks\">\n<caption class=\"muted\">%1</caption>\n"
                           "<tbody>\n")
                .arg(escaped(StudentReportText::tr("The checks of this step")));
    for (const CheckOutcome &check : report.checks) {
        QString text = escaped(check.title);
        if ((!check.passed || check.forTeacher) && !check.message.isEmpty())
            text +=
                QStringLiteral("<br><span class=\"muted\">%1</span>").arg(escaped(check.message));
        const double worth = roundedPoints(pointsInside(task, check.id) * pointScale(task));
        html +=
            QStringLiteral("<tr><td aria-label=\"%1\">%2</td><td>%3</td>"
                           "<td class=\"number\">%4</td></tr>\n")
                .arg(escaped(check.passed ? StudentReportText::tr("passed")
                                          : StudentReportText::tr("did not pass")),
                     check.passed ? QStringLiteral("✓") : QStringLiteral("✗"), text,
                     escaped(StudentReportText::tr("%1 of %2")
                                 .arg(countText(check.passed ? worth : 0.0), countText(worth))));
    }
    html += QStringLiteral("</tbody>\n</table>\n");
}

} // namespace

void writeReport(QString &html, const Task &task, const StepResult &step, const CheckReport &report)
{
    if (report.error)
        writeError(html, step, *report.error);
    for (std::size_t i = 0; i < report.findings.size(); ++i)
        writeFinding(html, step, report.findings[i], i);
    if (report.findings.empty() && !report.error) {
        for (const StepMoment &moment : step.moments)
            writeMoment(html, report, moment);
    }
    for (const Remark &remark : report.remarks)
        html +=
            QStringLiteral("<div class=\"note\">\n%1</div>\n").arg(markdownHtml(remark.message));
    if (!report.passed)
        writeChecks(html, task, report);
}

} // namespace cradle
