// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/workspace/git_handles.h"
#include "tasks/workspace/history.h"

namespace cradle {

/// What a History is made of.
struct History::Parts {
    GitLibrary library{}; ///< first: the repository goes before it
    QString folder{};
    GitRepository repository{};

    [[nodiscard]] Error fault() const { return gitError(folder); }
    /// By git's settings; empty if they have none.
    [[nodiscard]] QString userName() const;
    /// Who signs: git's settings, else \p author, else "Student".
    [[nodiscard]] GitSignature signature(const QString &author) const;
    /// The commit that a reference leads to; null if there is none.
    [[nodiscard]] GitCommit commitAt(const char *reference) const;
    /// What a commit has at \p path; nothing if it has nothing there, or is null.
    [[nodiscard]] std::optional<QByteArray> textIn(const git_commit *commit,
                                                   const QString &path) const;
};

/// Where the versions of a step are.
[[nodiscard]] QByteArray versionsRef(const QString &taskId);

inline constexpr char versionsFolder[] = "refs/cradle/versions/";
inline constexpr char notesFolder[] = "refs/cradle/notes/"; ///< those of what was noted about it

} // namespace cradle
