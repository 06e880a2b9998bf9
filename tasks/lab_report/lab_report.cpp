// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/lab_report.h"

#include "tasks/judging/judgement.h"
#include "tasks/lab/mode.h"
#include "tasks/lab_report/drawn_moment.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/report/report_text.h"
#include "tasks/text/plain_text.h"
#include "tasks/text/quantity_text.h"

#include <QCoreApplication>
#include <QtConcurrentMap>

#include <algorithm>

namespace cradle {

namespace {

struct ReportText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

constexpr double runSeconds = 10.0; ///< of the student's own scene that is told
constexpr int oneLine = 100'000;    ///< columns: not broken

/// The first sentence below the heading. (Plain text keeps no no-break space, as French titles
/// have.)
QString askedBy(const Task &task, bool byProgram)
{
    const QString title = task.title.simplified();
    const QString markdown = textFor(byProgram ? Mode::Code : Mode::Explore, task.instructions);
    for (const QString &paragraph : plainText(markdown, oneLine).split(QLatin1Char('\n'))) {
        const QString text = paragraph.trimmed();
        if (text.isEmpty() || text.simplified() == title || text.startsWith(QLatin1Char('#')))
            continue;
        const auto end = text.indexOf(QStringLiteral(". "));
        return end > 0 ? text.left(end + 1) : text;
    }
    return {};
}

QString momentText(const TellingMoment &moment)
{
    const QString time = quantityText(moment.time, 'f', 2);
    switch (moment.kind) {
    case TellingMoment::Kind::Circles:
        return ReportText::tr("At %1 s, when two circles first meet").arg(time);
    case TellingMoment::Kind::Wall:
        return ReportText::tr("At %1 s, when a circle first reaches a wall").arg(time);
    case TellingMoment::Kind::Time:
        break;
    }
    return ReportText::tr("At %1 s").arg(time);
}

/// What was found wrong, and how often; the name of a known mistake becomes its words.
void tellWay(StepReport &report, const Task &task, const StepWork &work)
{
    for (const KeptProgram &kept : work.versions) {
        if (!kept.version.note.passed)
            continue;
        ++report.attempts;
        for (const QString &finding : kept.version.note.findings) {
            const auto known =
                std::find_if(task.mistakes.begin(), task.mistakes.end(),
                             [&](const KnownScript &each) { return each.name == finding; });
            const QString headline =
                known == task.mistakes.end() ? finding : headlineOf(known->message);
            const auto met =
                std::find_if(report.met.begin(), report.met.end(),
                             [&](const auto &each) { return each.headline == headline; });
            if (met == report.met.end())
                report.met.push_back({headline, 1});
            else
                ++met->times;
        }
    }
    std::stable_sort(report.met.begin(), report.met.end(),
                     [](const auto &a, const auto &b) { return a.times > b.times; });
}

void tellPrediction(StepReport &report, const Task &task, const Guess &guess)
{
    if (!task.prediction)
        return;
    const Prediction &asked = *task.prediction;
    const auto answer = [&](int index) { return plainText(asked.answers.value(index), oneLine); };
    report.question = asked.question;
    report.right = answer(asked.right);
    if (!guess.answer)
        return;
    report.expected =
        *guess.answer == Guess::notSure ? ReportText::tr("not sure") : answer(*guess.answer);
    report.wasRight = *guess.answer == asked.right;
}

void tellRun(ToldStep &told, const Task &task, const Submission &submission)
{
    const Variant own{QStringLiteral("preset"), submission.preset, runSeconds, false, task.locked};
    const Observation run = observe(own, submission.program());
    if (run.states.isEmpty() || run.states.last() < 1)
        return;
    const TellingMoment moment = tellingMoment(run);
    told.report.moment = momentText(moment);
    told.report.scene = sceneSvg(drawnMoment(run, moment.index));
    told.report.momentum = momentumSvg(run);
    told.report.energy = energySvg(run);
    told.curve = energyCurve(task.id, run);
}

/// What a step's program is compared with: the student's own before it, else the lab's.
QString programBefore(const Lab &lab, const StudentWork &work, int index)
{
    for (auto before = static_cast<std::size_t>(index); before-- > 0;) {
        if (const auto &program = work.step(lab.tasks[before].id).program)
            return *program;
    }
    return lab.tasks[static_cast<std::size_t>(index)].starter;
}

} // namespace

ToldStep tellStep(const Lab &lab, const StudentWork &all, int index, qint64 seed)
{
    const Task &task = lab.tasks[static_cast<std::size_t>(index)];
    const StepWork &work = all.step(task.id);
    ToldStep told;
    StepReport &report = told.report;
    report.id = task.id;
    report.title = task.title;
    report.byProgram = work.program || !work.programFault.isEmpty();
    report.asked = askedBy(task, report.byProgram);
    report.note = work.note;
    tellPrediction(report, task, work.guess);
    tellWay(report, task, work);
    if (work.isEmpty())
        return told;
    if (!work.programFault.isEmpty()) {
        report.verdict = StepVerdict::Stopped;
        report.explanation = work.programFault;
        return told;
    }
    Submission submission(work.scene.value_or(task.preset), work.program);
    submission.answers = work.answers;
    const auto judged = judgeTask(lab, task, submission, seed);
    report.verdict = judged->passed  ? StepVerdict::Passed
                     : judged->error ? StepVerdict::Stopped
                                     : StepVerdict::NotPassed;
    for (std::size_t i = 0; i < judged->checks.size() && report.explanation.isEmpty(); ++i)
        report.explanation = plainText(feedbackOn(*judged, i, {}), oneLine);
    if (work.program)
        report.change = hunksOf(lineDiff(programBefore(lab, all, index), *work.program));
    tellRun(told, task, submission);
    return told;
}

QString nameOf(StepVerdict verdict)
{
    switch (verdict) {
    case StepVerdict::Passed:
        return QStringLiteral("passed");
    case StepVerdict::NotPassed:
        return QStringLiteral("not passed");
    case StepVerdict::Stopped:
        return QStringLiteral("stopped");
    case StepVerdict::NotDone:
        break;
    }
    return QStringLiteral("not done");
}

QString headlineOf(const QString &message)
{
    return plainText(message.section(QLatin1Char('\n'), 0, 0), oneLine).trimmed();
}

int LabReport::passedCount() const
{
    return static_cast<int>(std::count_if(steps.begin(), steps.end(), [](const StepReport &step) {
        return step.verdict == StepVerdict::Passed;
    }));
}

LabReport makeLabReport(const Lab &given, const StudentWork &work, qint64 seed,
                        const QDateTime &when, const std::function<void(int, int)> &progress,
                        const std::atomic_bool *cancelled)
{
    const Lab lab = forStudent(given, work.info.studentId);
    const int count = static_cast<int>(lab.tasks.size());
    std::vector<int> indices(lab.tasks.size());
    for (int i = 0; i < count; ++i)
        indices[static_cast<std::size_t>(i)] = i;
    std::atomic_int done = 0;
    const auto tell = [&](int index) {
        ToldStep told;
        if (!cancelled || !*cancelled)
            told = tellStep(lab, work, index, seed);
        if (progress)
            progress(++done, count);
        return told;
    };
    return reportOf(lab, work, when,
                    QtConcurrent::blockingMapped<std::vector<ToldStep>>(indices, tell));
}

LabReport reportOf(const Lab &lab, const StudentWork &work, const QDateTime &when,
                   std::vector<ToldStep> told)
{
    LabReport report{.labTitle = lab.title,
                     .labVersion = lab.version,
                     .student = work.info.student,
                     .studentId = work.info.studentId,
                     .when = when,
                     .noteToTeacher = work.noteToTeacher};
    std::vector<EnergyCurve> curves;
    for (ToldStep &step : told) {
        report.steps.push_back(std::move(step.report));
        if (!step.curve.points.empty())
            curves.push_back(std::move(step.curve));
    }
    if (!curves.empty())
        report.energies = energiesSvg(curves);
    return report;
}

} // namespace cradle
