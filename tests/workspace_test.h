// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "git_folder_test.h"
#include "tasks/workspace/workspace.h"

namespace cradle {

/// A test of workspaces of a lab of two steps, A and B; each in a new folder.
class WorkspaceTest : public GitFolderTest
{
protected:
    static inline const QString first = QStringLiteral("A");
    static inline const QString second = QStringLiteral("B");

    static Lab lab()
    {
        Lab lab;
        lab.id = QStringLiteral("lab-x");
        lab.version = QStringLiteral("1.2");
        lab.hash = QString(64, QLatin1Char('f'));
        for (const char *id : {"A", "B"}) {
            Task task;
            task.id = QLatin1String(id);
            task.starter = QStringLiteral("-- starter of %1\n").arg(task.id);
            lab.tasks.push_back(task);
        }
        return lab;
    }

    /// Puts the time of a file \p seconds before now.
    static void setAge(const QString &path, int seconds)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-seconds),
                                 QFileDevice::FileModificationTime));
    }
};

} // namespace cradle
