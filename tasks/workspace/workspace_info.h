// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <optional>

namespace cradle {

/// What a workspace says of itself, in cradle.json: whose it is, and of which lab.
struct WorkspaceInfo {
    QString labId{};
    QString labVersion{};
    QString labHash{};   ///< of the lab that was open last
    QString student{};   ///< name; empty if it was not given
    QString studentId{}; ///< number; empty if it was not given

    friend bool operator==(const WorkspaceInfo &, const WorkspaceInfo &) = default;
};

/// Whether \p folder says that it is a workspace.
[[nodiscard]] bool isWorkspace(const QString &folder);

/// Reads cradle.json of \p folder; empty fields where there is none.
Result<WorkspaceInfo> readWorkspaceInfo(const QString &folder);
/// The same from its text.
Result<WorkspaceInfo> workspaceInfoFrom(const QByteArray &text, const QString &source);

/// The text of cradle.json.
[[nodiscard]] QByteArray textOf(const WorkspaceInfo &info);

} // namespace cradle
