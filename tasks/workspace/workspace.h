// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab.h"

#include <map>

namespace cradle {

/// The student's programs of one lab, on disk: lab.lua, the one that is worked on, and
/// steps/ID.lua, what each step had last. Files are written whole or not at all.
class Workspace
{
public:
    /// \param folder  where the files are kept; empty: nowhere, all is forgotten at the end
    explicit Workspace(QString folder = {});

    [[nodiscard]] const QString &folder() const { return m_folder; }

    /// The program that step \p index of \p lab is worked on with: its own; else what the step
    /// before ended with; else what the lab starts the step from.
    [[nodiscard]] QString textOf(const Lab &lab, int index) const;
    /// What the step starts from when nothing has been done in it.
    [[nodiscard]] QString startOf(const Lab &lab, int index) const;

    /// Keeps \p text as that of the step, and as lab.lua.
    std::optional<Error> save(const QString &taskId, const QString &text);

private:
    [[nodiscard]] QString pathOf(const QString &taskId) const;
    [[nodiscard]] std::optional<QString> ownText(const QString &taskId) const;

    QString m_folder;
    std::map<QString, QString> m_texts; ///< where there is no folder
};

} // namespace cradle
