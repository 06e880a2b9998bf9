// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include "tasks/lab_report/lab_report.h"

#include <QDateTime>
#include <QRandomGenerator>

#include <algorithm>

namespace cradle {

// The check of the student's work, and the moment where it went wrong.

namespace {

/// How far the reference's run reaches beyond the moment shown, s of the scene.
constexpr double ghostSeconds = 10.0;

/// UTC, in whole seconds, as it is kept.
QDateTime now()
{
    return QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
}

} // namespace

Submission Workbench::submission() const
{
    Submission work(m_document.own(),
                    mode() == Mode::Code ? std::optional(m_code.text()) : std::nullopt);
    work.answers = answers();
    return work;
}

void Workbench::setGhost(std::shared_ptr<const Recording> ghost)
{
    m_reference.cancel();
    if (ghost == m_ghost)
        return;
    m_ghost = std::move(ghost);
    emit ghostChanged();
}

void Workbench::check()
{
    if (!task())
        return;
    // What was typed a moment ago is judged, not what still runs.
    m_code.apply();
    m_judged = submission();
    m_checker.start(m_lab, *task(), m_judged, QRandomGenerator::global()->bounded(1, 1000));
    emit checkStarted();
}

void Workbench::cancelCheck()
{
    m_checker.cancel();
}

void Workbench::finishCheck(const CheckReport &report)
{
    // A step that was left while it was judged keeps its verdict to itself.
    if (!task() || report.taskId != task()->id)
        return;
    m_report = report;
    keepChecked(report);
    m_awaitsRun = false;
    if (report.passed && (m_runSeen || progress().passed))
        countPass();
    else if (report.passed)
        awaitRun();
    showFirstFailure();
    emit reportChanged();
    if (m_judged != submission())
        emit reportStale(true);
}

/// Who passes without ever having looked sees the run now: what was checked is what it shows.
void Workbench::awaitRun()
{
    m_awaitsRun = true;
    if (m_judged != submission())
        return;
    m_document.leave();
    m_simulation.start();
}

/// Of the report, whose run was shown.
void Workbench::countPass()
{
    const bool finished = isLast() && !progress().passed;
    progress().passed = true;
    progress().pass = {.when = now(), .commit = m_report->commit};
    m_saveSoon.start();
    commitChecked();
    if (finished)
        emit labFinished();
}

/// Of a step or a mode that is left.
void Workbench::dropReport()
{
    m_report.reset();
    m_awaitsRun = false;
    forgetRun();
}

/// What is shown from now on is the run of other work.
void Workbench::forgetRun()
{
    m_runSeen = false;
}

/// Every program that was judged is a version.
void Workbench::keepChecked(const CheckReport &report)
{
    if (!mayWrite())
        return;
    VersionNote note{.reason = VersionReason::Checked,
                     .passed = report.passed,
                     .seed = report.seed,
                     .labHash = report.labHash};
    for (const Finding &finding : report.findings)
        note.findings.append(finding.mistake.isEmpty() ? headlineOf(finding.message)
                                                       : finding.mistake);
    if (m_judged.script)
        m_code.keepVersion(*m_judged.script, note);
}

/// What was passed becomes a commit.
void Workbench::commitChecked()
{
    if (!mayWrite())
        return;
    m_code.save();
    const auto scene =
        m_judged.preset == task()->preset ? std::nullopt : std::optional(m_judged.preset);
    if (const auto error = m_code.workspace().commitPass(*m_report, m_judged.script, scene))
        emit failed(*error);
    else
        emit stepCommitted();
}

/// Goes to where the student's own scene first went wrong, if it did there.
void Workbench::showFirstFailure()
{
    const auto &checks = m_report->checks;
    const auto failure = std::find_if(checks.begin(), checks.end(),
                                      [](const CheckOutcome &check) { return !check.passed; });
    if (failure != checks.end() && failure->step > 0 && failure->scene == m_document.own())
        showMoment(*failure);
}

void Workbench::showMoment(const CheckOutcome &outcome)
{
    if (!outcome.scene)
        return;
    const qint64 step = std::max<qint64>(0, outcome.step);
    if (*outcome.scene == m_document.own() && !outcome.pinned) {
        m_document.leave();
    } else {
        m_code.setPinned(outcome.pinned);
        m_document.visit(*outcome.scene);
    }
    m_visited = step;
    m_simulation.goTo(step);
    showReference(outcome, step);
}

/// Runs the reference in the same scene, to be seen beside the student's work as soon as it has
/// run.
void Workbench::showReference(const CheckOutcome &outcome, qint64 step)
{
    setGhost(nullptr); // of another moment
    if (!task() || task()->solution.isEmpty())
        return;
    const double seconds = static_cast<double>(step) * outcome.scene->timestep + ghostSeconds;
    m_reference.start({outcome.variant, *outcome.scene, seconds, outcome.pinned}, task()->solution);
}

void Workbench::markStale()
{
    setGhost(nullptr);
    if (m_report)
        emit reportStale(m_judged != submission()); // what was undone is fresh again
}

} // namespace cradle
