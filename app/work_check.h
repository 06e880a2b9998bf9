// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/fault_moment.h"
#include "app/kept_progress.h"
#include "tasks/judging/checker.h"

namespace cradle {

/// The check of the student's work on the open step, and what becomes of its verdict: a version, a
/// moment to look at, a step that is passed as soon as its run was shown.
class WorkCheck final : public QObject
{
    Q_OBJECT
public:
    /// All outlive this.
    WorkCheck(const LabPlace &place, PresetDocument &document, CodeSession &code,
              KeptProgress &progress, FaultMoment &moment);

    [[nodiscard]] const std::optional<CheckReport> &report() const { return m_report; }
    [[nodiscard]] bool isRunning() const { return m_checker.isRunning(); }
    /// Whether the last check passed, and the step counts as passed as soon as its run is shown.
    [[nodiscard]] bool awaitsRun() const { return m_awaitsRun; }

public slots:
    void start(); ///< judges the student's own scene, and program if any
    void cancel();
    void leave(); ///< the work that the report is about: another step, mode or scene opens

signals:
    void started();
    void progressed(int done, int total);
    void cancelled();
    void reported();        ///< a check ended, and with it the progress changed
    void stale(bool stale); ///< whether the work is no longer what the report is about
    void countedLater();    ///< the step was passed by the run that was shown, after the report
    void stepCommitted();   ///< a step was passed, and is in the history
    void labFinished();     ///< its last step was passed for the first time
    void failed(const cradle::Error &error); ///< could not be kept

private:
    [[nodiscard]] Submission submission() const;
    void finish(const CheckReport &report);
    void keepVersion(const CheckReport &report);
    void commit();
    void count();
    void awaitRun();
    void forgetRun();
    void noteShown();
    void showFirstFailure();
    void markStale();

    const LabPlace &m_place;
    PresetDocument &m_document;
    CodeSession &m_code;
    KeptProgress &m_progress;
    FaultMoment &m_moment;
    Checker m_checker;
    std::optional<CheckReport> m_report;
    Submission m_judged;      ///< what the last check was asked about
    bool m_runSeen = false;   ///< the run of the work as it is now was shown, beyond its start
    bool m_awaitsRun = false; ///< see awaitsRun()
};

} // namespace cradle
