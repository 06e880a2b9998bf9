// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "tasks/script/student_script.h"
#include "tasks/workspace/workspace.h"

#include <QFileSystemWatcher>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>

namespace cradle {

/// The student's program of the open step: kept on disk as it is typed, and put into the
/// simulation at once or when asked. What does not parse never replaces what runs.
class CodeSession final : public QObject
{
    Q_OBJECT
public:
    /// \param simulation  runs the program while the session is active; outlives it
    explicit CodeSession(Simulation &simulation, QObject *parent = nullptr);
    ~CodeSession() override;

    [[nodiscard]] Workspace &workspace() { return m_workspace; }
    [[nodiscard]] const Workspace &workspace() const { return m_workspace; }
    /// No step is open then.
    void setWorkspace(Workspace workspace);
    /// Opens the program of a step, in the scene that the simulation has.
    void open(const Lab &lab, int index);
    /// The same, but \p start alone begins the run, once: it is handed the new program() when the
    /// session has it, and puts it into the simulation with the scene that belongs to it.
    /// \param active  from now on
    void open(const Lab &lab, int index, bool active,
              const std::function<void(Program *program)> &start);
    /// There is no step, and so no program.
    void close();

    [[nodiscard]] const QString &text() const { return m_text; }
    /// Whether some version of the open text runs, or did when it was last active.
    [[nodiscard]] bool hasGoodVersion() const { return !m_running.isEmpty(); }
    /// The text of the program that moves the circles; empty while the laws do.
    [[nodiscard]] QString runningText() const { return m_active ? m_running : QString(); }
    [[nodiscard]] bool isOpen() const { return !m_taskId.isEmpty(); }
    [[nodiscard]] bool isSaved() const { return !m_unsaved && !m_workspace.hasUnsaved(); }
    /// Why the step's file is no program; nothing is shown then, and nothing may be typed.
    [[nodiscard]] const std::optional<Error> &foreign() const { return m_foreign; }
    /// Whether the text may be changed: it is a program, and this window may write.
    [[nodiscard]] bool isEditable() const;
    /// Of the open step.
    [[nodiscard]] const QString &taskId() const { return m_taskId; }
    /// What keeps the text from being read; the last good version runs on.
    [[nodiscard]] const std::optional<ProgramError> &fault() const { return m_fault; }
    /// The program for the simulation: null while the laws move the circles.
    [[nodiscard]] Program *program() const { return m_active ? m_script.get() : nullptr; }
    [[nodiscard]] bool isActive() const { return m_active; }
    void setActive(bool active);
    /// The scene keeps its values whatever on_load sets: it is one of a check.
    void setPinned(bool pinned);
    [[nodiscard]] bool appliesAtOnce() const { return m_atOnce; }
    void setAppliesAtOnce(bool atOnce);

public slots:
    void edit(const QString &text); ///< the student typed
    void apply();                   ///< runs the text from the start, if it can be read
    /// Takes \p text in place of the program, which becomes a version; it is saved like an edit.
    void replace(const QString &text);
    /// Keeps the program as a version, with what is known about it.
    void keepVersion(const QString &text, const cradle::VersionNote &note);
    /// What is typed becomes a version that long after the first change; ten minutes without this.
    void setKeepDelay(std::chrono::milliseconds delay) { m_keepSoon.setInterval(delay); }
    /// Takes the right to write from the window that has it; opens the step again.
    void takeOver(const cradle::Lab &lab, int index);
    /// Makes a program of the step's file that is none, or with \p convert false begins anew.
    void replaceForeign(const cradle::Lab &lab, int index, bool convert);
    void lookOutside(); ///< whether another program has changed the files
    void stepLine();    ///< pauses; to the next line of the update
    void finishStep();  ///< to the end of the update
    void save();        ///< now, if there is something to save

signals:
    void opened(const QString &text);       ///< of another step, or the same again
    void textReplaced(const QString &text); ///< of this step, not by the student's typing
    /// Another program changed the file. \p taken: its text is shown now; else what was typed here
    /// meanwhile is, and the other is among the versions.
    void changedOutside(bool taken);
    /// Another program has made the file \p name one that is no program; it is kept as \p kept.
    void setAside(const QString &name, const QString &kept);
    void versionsChanged();
    void edited();
    void stateChanged(); ///< saved, fault; also after opened(), when the program is in place
    void paused(const cradle::StudentScript::Pause &pause);
    void steppingEnded();
    void failed(const cradle::Error &error); ///< could not be saved
    void savedAgain();                       ///< after it had failed

private:
    void run();
    [[nodiscard]] std::unique_ptr<StudentScript> makeScript() const;
    void endStepping();
    void watch();
    void keepTyped();
    bool takeOutside();
    void finishSaving(const std::optional<Error> &error);

    Simulation &m_simulation;
    Workspace m_workspace;
    QString m_taskId;
    QString m_text;
    QStringList m_locked;                    ///< what the step fixes
    QString m_running;                       ///< the text of what runs
    std::unique_ptr<StudentScript> m_script; ///< what runs: the last text that could be read
    std::optional<ProgramError> m_fault;
    std::optional<Error> m_foreign;
    QTimer m_saveSoon;
    QTimer m_keepSoon; ///< a version of what is typed
    QTimer m_lookSoon;
    std::unique_ptr<QFileSystemWatcher> m_watcher;
    QTimer m_applySoon;
    bool m_unsaved = false;
    bool m_failing = false; ///< it could not be saved the last time
    bool m_active = false;
    bool m_pinned = false;
    bool m_atOnce = true;
    bool m_stepping = false;
};

} // namespace cradle
