// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/files/file_io.h"
#include "program_run.h"

namespace cradle::programs {

/// A test of what becomes of a student's folder "w": two steps of the bouncing ball, solved.
class WorkedFolderTest : public QObject
{
protected:
    [[nodiscard]] QString path(const char *name) const
    {
        return m_folder.filePath(QLatin1String(name));
    }
    void solveTwoSteps() const
    {
        QVERIFY(!makeFolder(path("w/steps")));
        for (const char *id : {"BALL1", "BALL2"}) {
            const QString from = sourcePath("tasks/labs/bouncing-ball/") + QLatin1String(id)
                                 + QStringLiteral("/solution.lua");
            QVERIFY(
                QFile::copy(from, path("w/steps/") + QLatin1String(id) + QStringLiteral(".lua")));
        }
        QVERIFY(!writeFile(path("w/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
    }

private:
    QTemporaryDir m_folder;
};

} // namespace cradle::programs
