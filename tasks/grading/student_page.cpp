// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/student_page.h"

#include "tasks/grading/page.h"
#include "tasks/grading/student_page_report.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct StudentText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

const QString studentStyle = QStringLiteral(R"css(
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
        m_html = pageStart(QStringLiteral("%1 – %2").arg(m_lab.title, name), m_facts.language,
                           studentStyle);
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
            m_html +=
                paragraph(QStringLiteral("%1 · %2").arg(
                              steps, StudentText::tr("%1 of %2 points")
                                         .arg(countText(*points.earned), countText(points.most))),
                          "sum");
        else
            m_html += paragraph(steps, "sum");
        if (notGraded > 0)
            m_html += paragraph(
                StudentText::tr("Steps that could not be graded: %1. There is no sum of points "
                                "yet; that is not the fault of what was handed in.")
                    .arg(notGraded));
        writeNumbers();
        const double kept = keptWhenLate(m_student.lateDays, m_facts.late);
        if (kept < 1.0)
            m_html += paragraph(
                StudentText::tr("Days late, a begun one counted whole: %1. That takes %2 % of "
                                "the points; the sum above has them taken off already.")
                    .arg(countText(std::ceil(m_student.lateDays)),
                         countText(roundedPoints(100.0 * (1.0 - kept)))));
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
            m_html += paragraph(
                StudentText::tr("What was handed in has the number %2, which the roster does "
                                "not have for this student: it was judged with the values "
                                "that are drawn by the number %1.")
                    .arg(step.drawnBy, step.ownNumber),
                "note");
        else if (!step.drawnBy.isEmpty())
            m_html +=
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
        const QString most = countText(points.most);
        return points.earned ? StudentText::tr("%1 of %2").arg(countText(*points.earned), most)
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
            m_html += paragraph(StudentText::tr("Nothing was handed in for this step."), "muted");
        if (!step.reason.isEmpty())
            m_html += paragraph(step.reason);
        if (step.status == StepResult::Status::NotGraded)
            m_html += paragraph(
                StudentText::tr("There is no verdict: this step counts neither as passed nor "
                                "as failed."));
        if (step.attempts > 0)
            m_html += paragraph(
                StudentText::tr("Checked %n time(s) while working on it.", nullptr, step.attempts),
                "muted");
        if (step.report)
            writeReport(m_html, task, step, *step.report);
        m_html += QStringLiteral("</section>\n");
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
