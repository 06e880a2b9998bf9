// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/student_page.h"

#include "tasks/grading/page.h"
#include "tasks/lab_report/lab_report.h"
#include "tasks/lab_report/markdown_html.h"
#include "tasks/text/quantity_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct StudentText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr std::size_t mostLocals = 6; ///< that are told with an error

const QString style = QStringLiteral(R"css(
.who { font-size: 1.05rem; margin: 0 0 1rem; }
.sum { font-size: 1.25rem; font-weight: 600; margin: .75rem 0 .25rem; }
.steps { width: 100%; } .steps td:first-child { white-space: nowrap; }
.note { border-inline-start: 4px solid var(--rule); padding: .1rem .9rem; margin: .75rem 0; }
.checks { width: 100%; margin-top: .5rem; } .checks td:first-child { width: 1.6rem; }
section > h2 .badge { margin-inline-start: .4rem; vertical-align: .12em; }
.finding { display: grid; grid-template-columns: minmax(0, 1fr) auto; gap: 0 1.5rem; }
.finding > figure { width: 300px; max-width: 100%; }
@media (max-width: 44rem) { .finding { grid-template-columns: minmax(0, 1fr); } }
@media print { section { break-inside: auto; } .finding > figure { width: 220px; } }
)css");

/// Writes the page piece by piece.
class Writer
{
public:
    Writer(const StudentResult &student, const Lab &lab, const ClassFacts &facts)
        : m_student(student)
        , m_lab(lab)
        , m_facts(facts)
    {
    }

    QByteArray write()
    {
        const QString name = m_student.name.isEmpty() ? m_student.id : m_student.name;
        m_html =
            pageStart(QStringLiteral("%1 – %2").arg(m_lab.title, name), m_facts.language, style);
        m_html += QStringLiteral("<header>\n<h1>%1</h1>\n").arg(escaped(m_lab.title));
        QStringList who{escapedName(name)};
        for (const QString &part : {m_student.number, m_facts.className}) {
            if (!part.isEmpty())
                who.append(escapedName(part));
        }
        m_html += QStringLiteral("<p class=\"who\">%1</p>\n</header>\n<main>\n")
                      .arg(who.join(QStringLiteral(" · ")));
        writeSum();
        writeSteps();
        for (const Task &task : m_lab.tasks)
            writeStep(task, resultOf(m_student, task));
        m_html += QStringLiteral("</main>\n");
        m_html += pageEnd(
            escaped(StudentText::tr("Judged by %1, version %2 of the lab, in scenes drawn for this "
                                    "student alone.")
                        .arg(m_facts.program.isEmpty() ? QStringLiteral("Cradle") : m_facts.program,
                             m_lab.version.isEmpty() ? QStringLiteral("?") : m_lab.version)));
        return m_html.toUtf8();
    }

private:
    void paragraph(const QString &text, const char *kind = "")
    {
        m_html +=
            QStringLiteral("<p%1>%2</p>\n")
                .arg(*kind ? QStringLiteral(" class=\"%1\"").arg(QLatin1String(kind)) : QString(),
                     escaped(text));
    }

    static QString number(double value) { return QLocale().toString(value, 'g', 8); }

    void writeSum()
    {
        int passed = 0;
        int notGraded = 0;
        for (const Task &task : m_lab.tasks) {
            const StepResult &step = resultOf(m_student, task);
            passed += step.status == StepResult::Status::Passed;
            notGraded += step.status == StepResult::Status::NotGraded;
        }
        const Points points = pointsOf(m_student, m_lab, m_facts.late);
        const QString steps =
            StudentText::tr("%1 of %2 steps pass").arg(passed).arg(m_lab.tasks.size());
        if (points.earned)
            paragraph(QStringLiteral("%1 · %2").arg(
                          steps, StudentText::tr("%1 of %2 points")
                                     .arg(number(*points.earned), number(points.most))),
                      "sum");
        else
            paragraph(steps, "sum");
        if (notGraded > 0)
            paragraph(
                StudentText::tr("Steps that could not be graded: %1. There is no sum of points "
                                "yet; that is not the fault of what was handed in.")
                    .arg(notGraded));
        writeNumbers();
        const double kept = keptWhenLate(m_student.lateDays, m_facts.late);
        if (kept < 1.0)
            paragraph(
                StudentText::tr("Days late, a begun one counted whole: %1. That takes %2 % of "
                                "the points; the sum above has them taken off already.")
                    .arg(number(std::ceil(m_student.lateDays)),
                         number(roundedPoints(100.0 * (1.0 - kept)))));
        if (!m_student.remark.trimmed().isEmpty())
            m_html += QStringLiteral("<div class=\"note\">%1</div>\n")
                          .arg(escaped(m_student.remark)
                                   .replace(QLatin1Char('\n'), QLatin1String("<br>")));
    }

    /// By which number values were drawn; the same for all steps.
    void writeNumbers()
    {
        if (m_student.steps.empty())
            return;
        const StepResult &step = m_student.steps.front();
        if (step.hasForeignNumber())
            paragraph(StudentText::tr("What was handed in has the number %2, which the roster does "
                                      "not have for this student: it was judged with the values "
                                      "that are drawn by the number %1.")
                          .arg(step.drawnBy, step.ownNumber),
                      "note");
        else if (!step.drawnBy.isEmpty())
            paragraph(StudentText::tr("The values of this lab were drawn by the number %1.")
                          .arg(step.drawnBy),
                      "muted");
    }

    static QString verdictBadge(const StepResult &step)
    {
        switch (step.status) {
        case StepResult::Status::Passed:
            return badge(StudentText::tr("✓ passes"), Tone::Good);
        case StepResult::Status::Missing:
            return badge(StudentText::tr("– not handed in"), Tone::Quiet);
        case StepResult::Status::NotGraded:
            return badge(StudentText::tr("? not graded"), Tone::Trouble);
        case StepResult::Status::Failed:
            break;
        }
        if (step.report && step.report->error)
            return badge(StudentText::tr("! stops with an error"), Tone::Trouble);
        return step.report ? badge(StudentText::tr("○ does not pass yet"), Tone::Open)
                           : badge(StudentText::tr("! cannot be read"), Tone::Trouble);
    }

    static QString pointsCell(const Points &points)
    {
        const QString most = number(points.most);
        return points.earned ? StudentText::tr("%1 of %2").arg(number(*points.earned), most)
                             : StudentText::tr("– of %1").arg(most);
    }

    void writeSteps()
    {
        m_html += QStringLiteral("<table class=\"steps\">\n<thead><tr><th>%1</th><th></th>"
                                 "<th>%2</th><th class=\"number\">%3</th></tr></thead>\n<tbody>\n")
                      .arg(escaped(StudentText::tr("Step")), escaped(StudentText::tr("Verdict")),
                           escaped(StudentText::tr("Points")));
        for (const Task &task : m_lab.tasks) {
            const StepResult &step = resultOf(m_student, task);
            m_html += QStringLiteral("<tr><td><a href=\"#%1\">%1</a></td><td>%2</td><td>%3</td>"
                                     "<td class=\"number\">%4</td></tr>\n")
                          .arg(escaped(task.id), escaped(task.title), verdictBadge(step),
                               escaped(pointsCell(pointsOf(step, task))));
        }
        m_html += QStringLiteral("</tbody>\n</table>\n");
    }

    void writeStep(const Task &task, const StepResult &step)
    {
        m_html += QStringLiteral("<section id=\"%1\">\n<h2>%1 · %2 %3</h2>\n")
                      .arg(escaped(task.id), escaped(task.title), verdictBadge(step));
        if (step.status == StepResult::Status::Missing)
            paragraph(StudentText::tr("Nothing was handed in for this step."), "muted");
        if (!step.reason.isEmpty())
            paragraph(step.reason);
        if (step.status == StepResult::Status::NotGraded)
            paragraph(StudentText::tr("There is no verdict: this step counts neither as passed nor "
                                      "as failed."));
        if (step.attempts > 0)
            paragraph(
                StudentText::tr("Checked %n time(s) while working on it.", nullptr, step.attempts),
                "muted");
        if (step.report)
            writeReport(task, step, *step.report);
        m_html += QStringLiteral("</section>\n");
    }

    void writeReport(const Task &task, const StepResult &step, const CheckReport &report)
    {
        if (report.error)
            writeError(step, *report.error);
        for (std::size_t i = 0; i < report.findings.size(); ++i)
            writeFinding(step, report.findings[i], i);
        if (report.findings.empty() && !report.error) {
            for (const StepMoment &moment : step.moments)
                writeMoment(report, moment);
        }
        for (const Remark &remark : report.remarks)
            m_html += QStringLiteral("<div class=\"note\">\n%1</div>\n")
                          .arg(markdownHtml(remark.message));
        if (!report.passed)
            writeChecks(task, report);
    }

    void writeError(const StepResult &step, const ProgramError &error)
    {
        const bool loads = error.step > 0;
        paragraph(loads ? StudentText::tr("The program stopped in step %1 of a scene, at %2 s.")
                              .arg(error.step)
                              .arg(number(error.time))
                        : StudentText::tr("The program does not load."));
        m_html +=
            QStringLiteral("<pre class=\"message\">%1</pre>\n")
                .arg(escaped(error.line > 0
                                 ? StudentText::tr("line %1: %2").arg(error.line).arg(error.message)
                                 : error.message));
        m_html += codeAround(step.program, error.line);
        QStringList values;
        for (const ProgramValue &local : error.locals) {
            if (static_cast<std::size_t>(values.size()) < mostLocals)
                values.append(QStringLiteral("<code>%1 = %2</code>")
                                  .arg(escaped(local.name), escaped(local.value)));
        }
        if (!values.isEmpty())
            m_html +=
                QStringLiteral("<p>%1 %2</p>\n")
                    .arg(escaped(StudentText::tr("There:")), values.join(QStringLiteral(", ")));
    }

    void writeFinding(const StepResult &step, const Finding &finding, std::size_t index)
    {
        m_html +=
            QStringLiteral(
                "<details class=\"printed\"%1>\n<summary>%2</summary>\n<div class=\"finding\">\n"
                "<div>\n%3")
                .arg(index == 0 ? QStringLiteral(" open") : QString(),
                     escaped(headlineOf(finding.message)),
                     markdownHtml(belowHeadline(finding.message)));
        const QString code = codeAround(step.program, finding.line);
        if (!code.isEmpty())
            paragraph(StudentText::tr("Look at line %1 of your program.").arg(finding.line));
        if (!finding.calls.empty()) {
            QStringList lines;
            for (const int line : finding.calls)
                lines.append(QString::number(line));
            paragraph(StudentText::tr("It is reached by the calls in line %1.")
                          .arg(lines.join(QStringLiteral(", "))),
                      "muted");
        }
        m_html += QStringLiteral("</div>\n");
        for (const StepMoment &moment : step.moments) {
            if (moment.check == finding.check)
                writeMoment(*step.report, moment);
        }
        m_html += QStringLiteral("</div>\n%1</details>\n").arg(code);
    }

    void writeMoment(const CheckReport &report, const StepMoment &moment)
    {
        const auto check =
            std::find_if(report.checks.begin(), report.checks.end(),
                         [&](const CheckOutcome &each) { return each.id == moment.check; });
        if (check == report.checks.end())
            return;
        QString caption =
            moment.scene.time > 0.0
                ? StudentText::tr("“%1” first goes wrong here, at %2 s.")
                      .arg(check->title, quantityText(moment.scene.time, 'f', 2))
                : StudentText::tr("“%1” goes wrong from the start.").arg(check->title);
        if (!check->variant.isEmpty() && check->variant != QLatin1String("preset"))
            caption += QLatin1Char(' ') + StudentText::tr("Scene: %1.").arg(check->variant);
        m_html += QStringLiteral("<figure class=\"scene\">\n%1<figcaption>%2</figcaption>\n"
                                 "</figure>\n")
                      .arg(QString::fromUtf8(sceneSvg(moment.scene)), escaped(caption));
    }

    void writeChecks(const Task &task, const CheckReport &report)
    {
        m_html += QStringLiteral("<table class=\"checks\">\n<caption class=\"muted\">%1</caption>\n"
                                 "<tbody>\n")
                      .arg(escaped(StudentText::tr("The checks of this step")));
        for (const CheckOutcome &check : report.checks) {
            QString text = escaped(check.title);
            if ((!check.passed || check.forTeacher) && !check.message.isEmpty())
                text += QStringLiteral("<br><span class=\"muted\">%1</span>")
                            .arg(escaped(check.message));
            const double worth = roundedPoints(pointsInside(task, check.id) * pointScale(task));
            m_html +=
                QStringLiteral("<tr><td aria-label=\"%1\">%2</td><td>%3</td>"
                               "<td class=\"number\">%4</td></tr>\n")
                    .arg(escaped(check.passed ? StudentText::tr("passed")
                                              : StudentText::tr("did not pass")),
                         check.passed ? QStringLiteral("✓") : QStringLiteral("✗"), text,
                         escaped(StudentText::tr("%1 of %2")
                                     .arg(number(check.passed ? worth : 0.0), number(worth))));
        }
        m_html += QStringLiteral("</tbody>\n</table>\n");
    }

    const StudentResult &m_student;
    const Lab &m_lab;
    const ClassFacts &m_facts;
    QString m_html{};
};

} // namespace

QByteArray studentPage(const StudentResult &student, const Lab &lab, const ClassFacts &facts)
{
    return Writer(student, lab, facts).write();
}

} // namespace cradle
