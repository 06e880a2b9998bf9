// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/code_session.h"
#include "app/examples.h"
#include "app/reference_run.h"
#include "tasks/judging/checker.h"
#include "tasks/lab/mode.h"
#include "tasks/questions/answers.h"
#include "tasks/workspace/progress.h"
#include "views/preset_document.h"

#include <QTimer>

namespace cradle {

/// What the student works on, without any window: the lab and its step, the scene, the program,
/// the check, and the progress that is kept between starts.
class Workbench final : public QObject
{
    Q_OBJECT
public:
    /// \param progressFile  where the progress is kept; the programs lie in "programs" beside it
    explicit Workbench(const QString &progressFile, QObject *parent = nullptr);
    ~Workbench() override;

    [[nodiscard]] const Lab &lab() const { return m_lab; }
    [[nodiscard]] int current() const { return m_current; } ///< −1: a scene without a step
    [[nodiscard]] const Task *task() const;                 ///< nullptr for a scene without a step
    /// The example that is open, if one is.
    [[nodiscard]] std::optional<Example> example() const { return m_example; }
    [[nodiscard]] Simulation &simulation() { return m_simulation; }
    [[nodiscard]] PresetDocument &document() { return m_document; }
    [[nodiscard]] CodeSession &code() { return m_code; }
    /// How the student works; a scene without a step can only be explored.
    [[nodiscard]] Mode mode() const { return m_code.isActive() ? Mode::Code : Mode::Explore; }
    /// The run of the reference in the scene shown, some time after showMoment(); null if there is
    /// none.
    [[nodiscard]] const std::shared_ptr<const Recording> &ghost() const { return m_ghost; }
    /// Whether the moment shown is where the check that showMoment() went to went wrong.
    [[nodiscard]] bool showsFault() const
    {
        return m_document.isVisiting()
               && m_simulation.recording().step(m_simulation.current()) == m_visited;
    }
    /// Whether the reference program may be seen: after passing, or after all hints.
    [[nodiscard]] bool mayShowSolution();
    [[nodiscard]] const std::optional<CheckReport> &report() const { return m_report; }
    [[nodiscard]] bool isChecking() const { return m_checker.isRunning(); }
    /// Whether the last check passed, and the step counts as passed as soon as its run is shown.
    [[nodiscard]] bool awaitsRun() const { return m_awaitsRun; }
    [[nodiscard]] std::vector<bool> passed() const; ///< one for each step
    [[nodiscard]] int hintsOpened();                ///< of the current step
    /// What the last check that the current step passed has left; invalid if there is none.
    [[nodiscard]] Pass pass();
    /// What the student expects of the current step.
    [[nodiscard]] Guess guess();
    /// What the student answers to the questions of the current step.
    [[nodiscard]] Answers answers() const;
    /// Whether this window may save: if not, another works on the lab (see the workspace).
    /// The text of the newest version of the open step's program; nothing if there is none.
    [[nodiscard]] std::optional<QString> newestVersion() const;
    [[nodiscard]] bool mayWrite() const { return m_code.workspace().mayWrite(); }
    /// Whether commits are signed "Student": neither git nor the workspace knows a name.
    [[nodiscard]] bool signsAsNobody() const;
    /// The step before, if the open one builds on its solution and the student has a program of
    /// neither: who jumped ahead.
    [[nodiscard]] const Task *missedTask() const;
    /// Whether nothing has ever been done in this lab.
    [[nodiscard]] bool isFirstStart() const { return m_firstStart; }

    /// Reads a lab and opens the step where the student left off.
    std::optional<Error> openLab(const QString &folder, const QString &language);
    /// Opens a workspace that lies anywhere, with the lab that it names: a clone of the student's
    /// own, or with \p readOnly one that was handed in, to be looked at.
    std::optional<Error> openWork(const QString &folder, bool readOnly, const QString &language);
    /// Whether the lab draws values for each student, and does not know for whom.
    [[nodiscard]] bool wantsNumber() const;
    /// Keeps the student's number, and shows the lab with the values that are drawn for it.
    std::optional<Error> setStudentNumber(const QString &number);
    /// Reads the same lab again, in another language; keeps step, scene and report.
    void setLanguage(const QString &language);
    /// Opens a scene that belongs to no step.
    std::optional<Error> openPreset(const QString &path);
    /// Opens a scene that ships with the program, in the same way.
    std::optional<Error> openExample(cradle::Example example);
    bool openTask(const QString &id);
    /// Takes a scene as the student's own of the current step; it can be undone.
    std::optional<Error> takePreset(const QString &path);
    /// Takes a file as the student's program of the current step.
    std::optional<Error> takeScript(const QString &path);

public slots:
    void setMode(cradle::Mode mode);
    void openTaskAt(int index);
    void openNextTask();
    void openPreviousTask();
    void check(); ///< judges the student's own scene
    void cancelCheck();
    void setHintsOpened(int count);
    void predict(int answer); ///< of the current step's prediction, or Guess::notSure
    void answer(const QString &question, const QJsonValue &value); ///< of the current step
    void revealOutcome(); ///< shows what the prediction was about
    /// The scene with which the open step was passed, where steps are worked on by scenes and
    /// another is there now.
    [[nodiscard]] std::optional<Preset> passedScene() const;
    void backToPassedScene();
    void startAfresh();       ///< the program of this step, from what the step before ended with
    void startFromSolution(); ///< of the step before, if it was missed
    void takeOver();          ///< the right to save, from the window that has it
    void convertProgram();    ///< the step's file, which is no program, becomes one
    void setProgramAside();   ///< the step begins anew; the file that is no program is kept
    /// Puts the newest version of the step's program in place of a file that is none.
    void recoverProgram();
    void showMoment(const cradle::CheckOutcome &outcome); ///< where a check went wrong
    void save();                                          ///< the progress, now

signals:
    void stepCommitted(); ///< a step was passed, and is in the history
    void labFinished();   ///< its last step was passed for the first time
    void numberWanted();  ///< see wantsNumber()
    void heldElsewhere(); ///< another window works on the lab that was opened
    void labChanged();
    void taskChanged();     ///< another step or scene, with its mode, report and progress
    void modeChanged();     ///< of the open step, which has no report in it yet
    void progressChanged(); ///< the open step was passed without another check
    void hintsChanged();
    void guessChanged();
    void ghostChanged();
    void checkStarted();
    void checkProgressed(int done, int total);
    void checkCancelled();
    void reportChanged();         ///< a check ended, and with it the progress changed
    void reportStale(bool stale); ///< whether the work is no longer what the report is about
    void failed(const cradle::Error &error); ///< something could not be saved or read

private:
    void openScene(const Preset &preset, std::optional<Example> example);
    std::optional<Error> openLabWith(const QString &folder, const QString &language,
                                     const QString &work, bool readOnly);
    void openWorkspace(const QString &folder, bool readOnly);
    void takeKeptProgress();
    void keepSaid();
    [[nodiscard]] bool isLast() const;
    void keepChecked(const CheckReport &report);
    void keepEdited();
    void finishCheck(const CheckReport &report);
    void commitChecked();
    void countPass();
    void awaitRun();
    void dropReport();
    void forgetRun();
    void showFirstFailure();
    void markStale();
    void noteWatched();
    void noteSeen();
    void showReference(const CheckOutcome &outcome, qint64 step);
    void setGhost(std::shared_ptr<const Recording> ghost);
    [[nodiscard]] Submission submission() const;
    TaskProgress &progress();

    ProgressStore m_store;
    Lab m_lab;
    int m_current = -1;
    std::optional<Example> m_example;
    bool m_firstStart = false;
    Simulation m_simulation;
    PresetDocument m_document;
    CodeSession m_code;
    QString m_progressFile;
    QString m_programs; ///< folder of the students' programs; empty: nowhere
    Mode m_wantedMode = Mode::Explore;
    Checker m_checker;
    std::optional<CheckReport> m_report;
    Submission m_judged;      ///< what the last check was asked about
    ReferenceRun m_reference; ///< makes the ghost
    std::shared_ptr<const Recording> m_ghost;
    qint64 m_visited = 0;     ///< step of showMoment()
    bool m_runSeen = false;   ///< the run of the work as it is now was shown, beyond its start
    bool m_awaitsRun = false; ///< see awaitsRun()
    QTimer m_saveSoon;
};

} // namespace cradle
