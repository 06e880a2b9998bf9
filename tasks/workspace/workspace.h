// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"
#include "tasks/workspace/history.h"
#include "tasks/workspace/workspace_info.h"
#include "tasks/workspace/workspace_lock.h"

#include <map>

namespace cradle {

/// What another program has made of a file of the workspace.
struct OutsideEdit {
    QString path;
    std::optional<QString> text{}; ///< none: it is no program any more

    friend bool operator==(const OutsideEdit &, const OutsideEdit &) = default;
};

/// The student's work in one lab, on disk: lab.lua, the program that is worked on; steps/ID.lua,
/// what each step had last; presets/ID.json, the scenes; notes/ID.md; cradle.json, whose it is.
/// Files are written whole or not at all. The folder is a git repository (see History).
///
/// One window at a time writes (see WorkspaceLock).
class Workspace
{
public:
    /// \param folder  where the files are kept; empty: nowhere, all is forgotten at the end
    explicit Workspace(QString folder = {});
    Workspace(Workspace &&) = default;
    Workspace &operator=(Workspace &&) = default;

    [[nodiscard]] const QString &folder() const { return m_folder; }

    /// Begins to work here: makes folder and repository if they are not there, takes over the
    /// programs of a folder that was none, and takes the lock.
    /// \param currentTask  the step that lab.lua belongs to; may be empty
    /// \return what keeps the history, or all, from being kept; programs are saved if they can be
    std::optional<Error> begin(const Lab &lab, const QString &currentTask = {});
    /// Only to be looked at: nothing is ever written.
    void beginReading();
    /// Whether it is only looked at.
    [[nodiscard]] bool isLookedAt() const { return m_lookedAt; }
    /// Whether this window may write; if not, another has the lock, or it is only looked at.
    [[nodiscard]] bool mayWrite() const { return !m_readOnly; }
    /// Who else writes here.
    [[nodiscard]] const std::optional<LockHolder> &holder() const { return m_holder; }
    /// Takes the right to write from them.
    void takeOver();

    /// The program that step \p index of \p lab is worked on with: its own; else what startOf()
    /// says. \return an error if there is a file that is no program; nothing replaces it
    Result<QString> textOf(const Lab &lab, int index) const;
    /// Whether the step has a program of its own.
    [[nodiscard]] bool has(const QString &taskId) const;
    /// What the step starts from when nothing has been done in it: the student's own program of
    /// the nearest step before; else what the lab gives at the beginning of the steps that build
    /// on each other. Never the solution of a step that the student has not done.
    [[nodiscard]] QString startOf(const Lab &lab, int index) const;

    /// Keeps \p text as that of the step, and as lab.lua. What cannot be saved is kept in memory.
    std::optional<Error> save(const QString &taskId, const QString &text);
    /// Whether there is text that could not be saved.
    [[nodiscard]] bool hasUnsaved() const
    {
        return !m_folder.isEmpty() && !(m_texts.empty() && m_notes.empty());
    }
    /// Tries again.
    std::optional<Error> saveUnsaved();

    /// What of the step's file and lab.lua is no longer as it was read or saved, the newest last.
    [[nodiscard]] std::vector<OutsideEdit> outsideEdits(const QString &taskId) const;
    /// Keeps such an edit as a version; it is known then. A file that is no program is also kept
    /// beside, and what can be read of it becomes the version.
    /// \return the file that it is kept as; empty if it is a program
    Result<QString> keepOutside(const QString &taskId, const OutsideEdit &edit);

    /// Whether the step's file, which is no program, can be made one.
    [[nodiscard]] bool canConvert(const QString &taskId) const;
    /// Makes it one; with \p convert false the step begins anew. The file is kept beside it.
    std::optional<Error> replaceForeign(const Lab &lab, int index, bool convert);

    /// The history; null if there is none.
    [[nodiscard]] const History *history() const { return m_history.get(); }
    [[nodiscard]] History *history() { return m_history.get(); }
    /// Keeps a version; one that was not judged only if the text is not that of the newest.
    std::optional<Error> keep(const QString &taskId, const QString &text, const VersionNote &note);
    /// The student's own scene with which the step was last passed; none if it was that of the lab.
    [[nodiscard]] std::optional<Preset> passedScene(const QString &taskId) const;

    /// Commits the work as it is, for a step that was passed.
    /// \param program  that passed, which the file may have left behind; none in explore mode
    /// \param scene    the student's own scene; none if it is that of the lab
    std::optional<Error> commitPass(const CheckReport &report,
                                    const std::optional<QString> &program,
                                    const std::optional<Preset> &scene);

    [[nodiscard]] const WorkspaceInfo &info() const { return m_info; }
    std::optional<Error> setStudent(const QString &name, const QString &number);

    /// What the student has noted about a step, Markdown; empty if nothing.
    [[nodiscard]] QString noteOf(const QString &taskId) const;
    /// What cannot be saved is kept in memory. What another program has made of the file is kept,
    /// too. \return what went wrong, or where that is
    std::optional<Error> saveNote(const QString &taskId, const QString &text);
    /// Keeps the note, as it was saved, as a version.
    std::optional<Error> keepNote(const QString &taskId);

    /// Keeps \p name (predictions.json, answers.json), if it says something else.
    std::optional<Error> saveSaid(const QString &name, const QByteArray &text);

    [[nodiscard]] QString pathOf(const QString &taskId) const;
    [[nodiscard]] QString labPath() const;

private:
    [[nodiscard]] Result<std::optional<QString>> ownText(const QString &taskId) const;
    [[nodiscard]] bool wasTakenOver();
    Result<QString> moveAside(const QString &path);
    [[nodiscard]] QString scenePath(const QString &taskId) const
    {
        return m_folder + QStringLiteral("/presets/%1.json").arg(taskId);
    }
    [[nodiscard]] QString notePath(const QString &taskId) const;
    std::optional<Error> keepOthersNote(const QString &taskId);
    std::optional<Error> write(const QString &path, const QByteArray &text);
    std::optional<Error> openHistory();
    std::optional<Error> takeLabFile(const QString &currentTask);
    std::optional<Error> saveInfo();

    QString m_folder;
    std::map<QString, QString> m_texts; ///< where there is no folder, or that is not yet saved
    std::map<QString, QString> m_notes; ///< the same
    /// The files as they were read or written last.
    mutable std::map<QString, QByteArray> m_known;
    WorkspaceInfo m_info;
    WorkspaceLock m_lock;
    std::optional<LockHolder> m_holder;
    bool m_readOnly = false;
    bool m_lookedAt = false; ///< and never written
    bool m_hasLock = false;  ///< the lock was taken, by us
    std::unique_ptr<History> m_history;
};

} // namespace cradle
