// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/code_run.h"
#include "tasks/workspace/workspace.h"

#include <QFileSystemWatcher>
#include <QTimer>

#include <chrono>
#include <memory>

namespace cradle {

/// The text of the student's program of the open step, kept on disk as it is typed: what is saved,
/// what others change, what of it is a version. Its run() gets it at once or when asked.
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
    /// The same, but \p start alone begins the run; see CodeRun::open().
    void open(const Lab &lab, int index, bool active, const CodeRun::Start &start);
    /// There is no step, and so no program.
    void close();

    [[nodiscard]] CodeRun &run() { return m_run; }
    [[nodiscard]] const CodeRun &run() const { return m_run; }
    [[nodiscard]] const QString &text() const { return m_text; }
    [[nodiscard]] bool isOpen() const { return !m_taskId.isEmpty(); }
    [[nodiscard]] bool isSaved() const { return !m_unsaved && !m_workspace.hasUnsaved(); }
    /// Why the step's file is no program; nothing is shown then, and nothing may be typed.
    [[nodiscard]] const std::optional<Error> &foreign() const { return m_foreign; }
    /// Whether the text may be changed: it is a program, and this window may write.
    [[nodiscard]] bool isEditable() const;
    /// Of the open step.
    [[nodiscard]] const QString &taskId() const { return m_taskId; }
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
    void failed(const cradle::Error &error); ///< could not be saved
    void savedAgain();                       ///< after it had failed

private:
    void watch();
    void keepTyped();
    bool takeOutside();
    void finishSaving(const std::optional<Error> &error);

    Simulation &m_simulation;
    CodeRun m_run;
    Workspace m_workspace;
    QString m_taskId;
    QString m_text;
    std::optional<Error> m_foreign;
    QTimer m_saveSoon;
    QTimer m_keepSoon; ///< a version of what is typed
    QTimer m_lookSoon;
    std::unique_ptr<QFileSystemWatcher> m_watcher;
    QTimer m_applySoon;
    bool m_unsaved = false;
    bool m_failing = false; ///< it could not be saved the last time
    bool m_atOnce = true;
};

} // namespace cradle
