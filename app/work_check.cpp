// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/work_check.h"

#include "tasks/lab_report/lab_report.h"

#include <QDateTime>
#include <QRandomGenerator>

#include <algorithm>

namespace cradle {

namespace {

/// UTC, in whole seconds, as it is kept.
QDateTime now()
{
    return QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
}

bool isLast(const LabPlace &place)
{
    const auto &tasks = place.lab.tasks;
    const auto last =
        std::find_if(tasks.rbegin(), tasks.rend(), [](const Task &each) { return !each.extra; });
    return last != tasks.rend() && place.task() == &*last;
}

} // namespace

WorkCheck::WorkCheck(const LabPlace &place, PresetDocument &document, CodeSession &code,
                     KeptProgress &progress, FaultMoment &moment)
    : m_place(place)
    , m_document(document)
    , m_code(code)
    , m_progress(progress)
    , m_moment(moment)
{
    const auto workChanged = [this] {
        forgetRun();
        markStale();
    };
    connect(&document, &PresetDocument::edited, this, workChanged);
    connect(&code, &CodeSession::edited, this, workChanged);
    connect(&code, &CodeSession::opened, this, &WorkCheck::forgetRun);
    connect(&code, &CodeSession::textReplaced, this, &WorkCheck::forgetRun);
    connect(&progress, &KeptProgress::answersChanged, this, &WorkCheck::markStale);
    connect(&document.simulation(), &Simulation::frameReady, this, &WorkCheck::noteShown);
    connect(&m_checker, &Checker::progressed, this, &WorkCheck::progressed);
    connect(&m_checker, &Checker::finished, this, &WorkCheck::finish);
    connect(&m_checker, &Checker::cancelled, this, &WorkCheck::cancelled);
}

Submission WorkCheck::submission() const
{
    Submission work(m_document.own(),
                    m_code.run().isActive() ? std::optional(m_code.text()) : std::nullopt);
    work.answers = m_progress.answers();
    return work;
}

void WorkCheck::start()
{
    if (!m_place.task())
        return;
    // What was typed a moment ago is judged, not what still runs.
    m_code.apply();
    m_judged = submission();
    m_checker.start(m_place.lab, *m_place.task(), m_judged,
                    QRandomGenerator::global()->bounded(1, 1000));
    emit started();
}

void WorkCheck::cancel()
{
    m_checker.cancel();
}

void WorkCheck::leave()
{
    cancel();
    m_report.reset();
    m_awaitsRun = false;
    forgetRun();
}

void WorkCheck::finish(const CheckReport &report)
{
    // A step that was left while it was judged keeps its verdict to itself.
    if (!m_place.task() || report.taskId != m_place.task()->id)
        return;
    m_report = report;
    keepVersion(report);
    m_awaitsRun = false;
    if (report.passed && (m_runSeen || m_progress.isPassed(*m_place.task())))
        count();
    else if (report.passed)
        awaitRun();
    showFirstFailure();
    emit reported();
    if (m_judged != submission())
        emit stale(true);
}

/// Who passes without ever having looked sees the run now: what was checked is what it shows.
void WorkCheck::awaitRun()
{
    m_awaitsRun = true;
    if (m_judged != submission())
        return;
    m_document.leave();
    m_document.simulation().start();
}

/// Of the report, whose run was shown.
void WorkCheck::count()
{
    const bool finished = isLast(m_place) && !m_progress.isPassed(*m_place.task());
    m_progress.notePassed({.when = now(), .commit = m_report->commit});
    commit();
    if (finished)
        emit labFinished();
}

/// What is shown from now on is the run of other work.
void WorkCheck::forgetRun()
{
    m_runSeen = false;
}

/// A pass needs a run that was seen: of this work, not of a scene of the check or of the last text
/// that could be read.
void WorkCheck::noteShown()
{
    if (m_runSeen || m_document.simulation().atStart() || !m_place.task() || m_document.isVisiting()
        || (m_code.run().isActive() && m_code.run().text() != m_code.text()))
        return;
    m_runSeen = true;
    if (!m_awaitsRun || m_judged != submission())
        return;
    m_awaitsRun = false;
    count();
    emit countedLater();
}

/// Every program that was judged is a version.
void WorkCheck::keepVersion(const CheckReport &report)
{
    if (!m_code.workspace().mayWrite() || !m_judged.script)
        return;
    VersionNote note{.reason = VersionReason::Checked,
                     .passed = report.passed,
                     .seed = report.seed,
                     .labHash = report.labHash};
    for (const Finding &finding : report.findings)
        note.findings.append(finding.mistake.isEmpty() ? headlineOf(finding.message)
                                                       : finding.mistake);
    m_code.keepVersion(*m_judged.script, note);
}

/// What was passed becomes a commit.
void WorkCheck::commit()
{
    if (!m_code.workspace().mayWrite())
        return;
    m_code.save();
    const auto scene =
        m_judged.preset == m_place.task()->preset ? std::nullopt : std::optional(m_judged.preset);
    if (const auto error = m_code.workspace().commitPass(*m_report, m_judged.script, scene))
        emit failed(*error);
    else
        emit stepCommitted();
}

/// Goes to where the student's own scene first went wrong, if it did there.
void WorkCheck::showFirstFailure()
{
    const auto &checks = m_report->checks;
    const auto failure = std::find_if(checks.begin(), checks.end(),
                                      [](const CheckOutcome &check) { return !check.passed; });
    if (failure != checks.end() && failure->step > 0 && failure->scene == m_document.own())
        m_moment.show(*failure);
}

void WorkCheck::markStale()
{
    m_moment.forgetGhost();
    if (m_report)
        emit stale(m_judged != submission()); // what was undone is fresh again
}

} // namespace cradle
