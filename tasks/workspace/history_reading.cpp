// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/history.h"

#include "tasks/workspace/history_parts.h"

#include <QTimeZone>

namespace cradle {

// What was kept, read back.

namespace {

QString textOfId(const git_oid *id)
{
    char hex[GIT_OID_HEXSZ + 1] = {};
    git_oid_fmt(hex, id);
    return QString::fromLatin1(hex);
}

Version versionFrom(const git_commit *commit)
{
    const QString message = QString::fromUtf8(git_commit_message(commit));
    return {.id = textOfId(git_commit_id(commit)),
            .taskId = trailerOf(message, QStringLiteral("Cradle-Step")),
            .when = QDateTime::fromSecsSinceEpoch(git_commit_time(commit), Qt::UTC),
            .note = versionNote(message)};
}

} // namespace

std::vector<Version> History::versions(const QString &taskId, int most) const
{
    std::vector<Version> found;
    GitCommit commit = m_parts->commitAt(versionsRef(taskId).constData());
    while (commit && static_cast<int>(found.size()) < most) {
        found.push_back(versionFrom(commit.get()));
        found.back().taskId = taskId;
        commit = makeGit<GitCommit>(git_commit_parent, commit.get(), 0u);
    }
    return found;
}

Result<QByteArray> History::textOf(const Version &version) const
{
    git_repository *repository = m_parts->repository.get();
    git_oid id;
    if (git_oid_fromstr(&id, version.id.toLatin1().constData()) != 0)
        return m_parts->fault();
    const auto commit = makeGit<GitCommit>(git_commit_lookup, repository, &id);
    const auto text =
        m_parts->textIn(commit.get(), QStringLiteral("steps/%1.lua").arg(version.taskId));
    return text ? Result<QByteArray>(*text) : m_parts->fault();
}

std::vector<Version> History::passes(int most) const
{
    std::vector<Version> found;
    const auto walk = makeGit<GitRevwalk>(git_revwalk_new, m_parts->repository.get());
    if (!walk || git_revwalk_push_head(walk.get()) != 0)
        return found;
    git_revwalk_sorting(walk.get(), GIT_SORT_TOPOLOGICAL);
    git_oid id;
    for (int seen = 0; seen < most && git_revwalk_next(&id, walk.get()) == 0; ++seen) {
        const auto commit = makeGit<GitCommit>(git_commit_lookup, m_parts->repository.get(), &id);
        if (!commit)
            break;
        Version version = versionFrom(commit.get());
        if (version.note.passed == true && !version.taskId.isEmpty())
            found.push_back(std::move(version));
    }
    return found;
}

} // namespace cradle
