// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/simulation.h"
#include "tasks/script/student_script.h"
#include "tasks/workspace/workspace.h"

#include <QTimer>

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

    [[nodiscard]] const Workspace &workspace() const { return m_workspace; }
    void setWorkspace(Workspace workspace) { m_workspace = std::move(workspace); }
    /// Opens the program of a step; \p preset follows it in the simulation.
    void open(const Lab &lab, int index);
    /// There is no step, and so no program.
    void close();

    [[nodiscard]] const QString &text() const { return m_text; }
    /// The text of the program that moves the circles; empty while the laws do.
    [[nodiscard]] QString runningText() const { return m_active ? m_running : QString(); }
    [[nodiscard]] bool isOpen() const { return !m_taskId.isEmpty(); }
    [[nodiscard]] bool isSaved() const { return !m_unsaved; }
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
    [[nodiscard]] bool isStepping() const { return m_stepping; }

public slots:
    void edit(const QString &text); ///< the student typed
    void apply();                   ///< runs the text from the start, if it can be read
    /// Takes \p text in place of the program; it is saved like an edit.
    void replace(const QString &text);
    void stepLine();   ///< pauses; to the next line of the update
    void finishStep(); ///< to the end of the update
    void save();       ///< now, if there is something to save

signals:
    void textReplaced(const QString &text); ///< not by the student's typing
    void edited();
    void stateChanged(); ///< saved, fault
    void paused(const cradle::StudentScript::Pause &pause);
    void steppingEnded();
    void failed(const cradle::Error &error); ///< could not be saved

private:
    void run();
    void endStepping();

    Simulation &m_simulation;
    Workspace m_workspace;
    QString m_taskId;
    QString m_text;
    QStringList m_locked;                    ///< what the step fixes
    QString m_running;                       ///< the text of what runs
    std::unique_ptr<StudentScript> m_script; ///< what runs: the last text that could be read
    std::optional<ProgramError> m_fault;
    QTimer m_saveSoon;
    QTimer m_applySoon;
    bool m_unsaved = false;
    bool m_active = false;
    bool m_pinned = false;
    bool m_atOnce = true;
    bool m_stepping = false;
};

} // namespace cradle
