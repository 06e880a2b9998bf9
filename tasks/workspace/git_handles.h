// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <git2.h>

#include <QByteArray>
#include <QCoreApplication>

#include <memory>

namespace cradle {

// Owners of what libgit2 gives out; only tasks/workspace includes this.

template <auto Free>
struct FreeGit {
    template <typename T>
    void operator()(T *object) const
    {
        Free(object);
    }
};

using GitRepository = std::unique_ptr<git_repository, FreeGit<git_repository_free>>;
using GitIndex = std::unique_ptr<git_index, FreeGit<git_index_free>>;
using GitTree = std::unique_ptr<git_tree, FreeGit<git_tree_free>>;
using GitTreeEntry = std::unique_ptr<git_tree_entry, FreeGit<git_tree_entry_free>>;
using GitCommit = std::unique_ptr<git_commit, FreeGit<git_commit_free>>;
using GitBlob = std::unique_ptr<git_blob, FreeGit<git_blob_free>>;
using GitSignature = std::unique_ptr<git_signature, FreeGit<git_signature_free>>;
using GitConfig = std::unique_ptr<git_config, FreeGit<git_config_free>>;
using GitRevwalk = std::unique_ptr<git_revwalk, FreeGit<git_revwalk_free>>;
using GitReference = std::unique_ptr<git_reference, FreeGit<git_reference_free>>;
using GitRemote = std::unique_ptr<git_remote, FreeGit<git_remote_free>>;

/// libgit2 counts how often it was begun.
class GitLibrary
{
public:
    GitLibrary() { git_libgit2_init(); }
    ~GitLibrary() { git_libgit2_shutdown(); }
    GitLibrary(const GitLibrary &) = delete;
    GitLibrary &operator=(const GitLibrary &) = delete;
};

/// Calls a function of libgit2 that makes an object; \return null on failure.
template <typename Owner, typename Make, typename... Arguments>
[[nodiscard]] Owner makeGit(Make make, Arguments... arguments)
{
    typename Owner::pointer object = nullptr;
    return make(&object, arguments...) == 0 ? Owner(object) : Owner();
}

/// What libgit2 said last, about \p path.
[[nodiscard]] inline Error gitError(const QString &path)
{
    const git_error *last = git_error_last();
    return {.message = QCoreApplication::translate("Workspace",
                                                   "the history of your work cannot be kept: %1")
                           .arg(QString::fromUtf8(last ? last->message : "?")),
            .file = path};
}

} // namespace cradle
