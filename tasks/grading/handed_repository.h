// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/workspace/git_objects.h"

namespace cradle {

/// The files with the history of the repository \p folder (.git), as bytes: HEAD, references and
/// objects. Settings, hooks, alternates and all else are not even opened, and no link out of
/// \p root is followed.
/// \return nothing where there is none; an error if there is more of it than is looked at
Result<RepositoryFiles> readRepository(const QByteArray &root, const QByteArray &folder);

/// Whether the file \p path of a repository is one that readRepository() takes.
[[nodiscard]] bool isOfHistory(const QByteArray &path);

} // namespace cradle
