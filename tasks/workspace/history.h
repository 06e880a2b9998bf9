// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/workspace/version.h"

#include <QByteArray>
#include <QMap>

#include <memory>
#include <optional>
#include <vector>

namespace cradle {

/// The git repository of a workspace, without the program git: on the branch that is checked out
/// the story of the lab, a commit for every step that was passed; on refs/cradle/versions/STEP
/// every state of a step's program that was kept, and on refs/cradle/notes/STEP what was noted.
///
/// Everything in it may have been written by others and is only data.
class History
{
public:
    /// Opens the repository in \p folder, or makes one there with the branch main.
    static Result<std::unique_ptr<History>> open(const QString &folder);
    /// Opens what is there; an error if it is no repository.
    static Result<std::unique_ptr<History>> openExisting(const QString &folder);
    /// A new one as open() makes it, of what can be made again: what is kept in it is on the disk
    /// some seconds later, and thousands of versions take no minutes.
    static Result<std::unique_ptr<History>> makeDerivable(const QString &folder);
    ~History();
    History(const History &) = delete;
    History &operator=(const History &) = delete;

    /// The folder with git's own files.
    [[nodiscard]] QString gitFolder() const;
    /// Removes the locks of git's own files that a process left which was killed after \p since:
    /// nothing could be kept any more. Only for who knows that it was.
    void removeLocksSince(const QDateTime &since);
    /// Whether nothing was committed yet.
    [[nodiscard]] bool isEmpty() const;
    /// The name that git signs with; empty if its settings have none.
    [[nodiscard]] QString gitName() const;

    /// Commits all files of the workspace (see workspace.h) as they are on the disk.
    /// \param author   who signs where git's settings name nobody
    /// \param instead  by path: what is committed in the place of what is on the disk
    std::optional<Error> commit(const QString &message, const QString &author,
                                const QMap<QString, QByteArray> &instead = {});
    /// Keeps \p text as a version of the step's program.
    /// \param when  of a version that is older than now
    std::optional<Error> keep(const QString &taskId, const QByteArray &text,
                              const VersionNote &note, const QString &author,
                              const QDateTime &when = {});

    /// Keeps \p text as a version of what was noted about the step, if it is not the newest.
    std::optional<Error> keepNote(const QString &taskId, const QByteArray &text,
                                  const QString &author);

    /// The versions of a step, the newest first; at most \p most.
    [[nodiscard]] std::vector<Version> versions(const QString &taskId, int most = 1000) const;
    /// The text of a version.
    Result<QByteArray> textOf(const Version &version) const;

    /// The commits of the story in which a step was passed, as versions, the newest first.
    [[nodiscard]] std::vector<Version> passes(int most = 10000) const;

    /// The address that the work is shared with; empty if there is none.
    [[nodiscard]] QString remoteUrl() const;
    std::optional<Error> setRemoteUrl(const QString &url);
    /// Sends the story and the versions there. \return what kept it from being sent, in words
    std::optional<Error> push();
    /// The time of the newest commit that was sent, as this repository knows; invalid: none was.
    [[nodiscard]] QDateTime lastPush() const;

    /// The story and the versions as one file that git can clone from (a bundle).
    Result<QByteArray> bundle() const;

private:
    struct Parts;
    explicit History(std::unique_ptr<Parts> parts);
    std::optional<Error> keepFile(const QByteArray &reference, const QString &path,
                                  const QByteArray &text, const QString &message,
                                  const QString &author, const QDateTime &when);

    std::unique_ptr<Parts> m_parts;
};

} // namespace cradle
