// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/code_session.h"

namespace cradle {

/// A lab of two steps.
inline Lab twoSteps()
{
    Lab lab;
    lab.id = QStringLiteral("lab-x");
    for (const char *id : {"A", "B"}) {
        Task task;
        task.id = QLatin1String(id);
        task.starter = QStringLiteral("-- start\n");
        lab.tasks.push_back(task);
    }
    return lab;
}

/// Opens its first step in \p folder.
inline void open(CodeSession &session, const QString &folder)
{
    Workspace workspace(folder);
    (void)workspace.begin(twoSteps());
    session.setWorkspace(std::move(workspace));
    session.open(twoSteps(), 0);
}

} // namespace cradle
