// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/workspace/git_objects.h"
#include "tasks/workspace/version.h"

#include <map>

namespace cradle {

/// When a stranger's repository says that the programs of \p steps were worked on, by step: every
/// state that Cradle kept (refs/cradle/versions/ID), every pass in the story, and every commit that
/// changed steps/ID.lua. A verdict is told only of kept states, of which none is left out. Anybody
/// can write any history.
[[nodiscard]] std::map<QString, std::vector<Version>> keptHistory(const RepositoryFiles &files,
                                                                  const QStringList &steps);

} // namespace cradle
