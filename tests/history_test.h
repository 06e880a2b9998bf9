// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "git_folder_test.h"
#include "model/files/file_io.h"
#include "tasks/workspace/history.h"

namespace cradle {

/// A test of the history of a folder with one step's program.
class HistoryTest : public GitFolderTest
{
protected:
    static inline const QString task = QStringLiteral("L42T5");
    static inline const QString student = QStringLiteral("Ada Lovelace");

    void writeProgram()
    {
        takeNewFolder();
        QVERIFY(!makeFolder(path("w/steps")));
        QVERIFY(!writeFile(path("w/steps/L42T5.lua"), "-- one\n"));
        QVERIFY(!writeFile(path("w/lab.lua"), "-- one\n"));
    }

    [[nodiscard]] std::unique_ptr<History> opened() const
    {
        auto history = History::open(path());
        return history ? std::move(*history) : nullptr;
    }

    /// What is noted of a version that was judged.
    static VersionNote checked(bool passed)
    {
        return {.reason = VersionReason::Checked,
                .passed = passed,
                .seed = 17,
                .labHash = QString(64, QLatin1Char('a')),
                .findings =
                    passed ? QStringList() : QStringList{QStringLiteral("both-symplectic")}};
    }
};

} // namespace cradle
