// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "git_folder_test.h"
#include "tasks/hand_in/hand_in.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/workspace/workspace.h"

namespace cradle {

/// A test of what a student of the bouncing ball hands in.
class HandInTest : public GitFolderTest
{
protected:
    void readTheLab()
    {
        auto lab = readLab(QLatin1String(bouncingBallLab));
        QVERIFY(lab);
        m_lab = std::move(*lab);
    }

    /// Step 1 passes, after an attempt that did not; step 2 stops with an error; step 3 is not
    /// done.
    void workOnTheLab()
    {
        takeNewFolder();
        Workspace workspace(path("w"));
        QVERIFY(!workspace.begin(m_lab));
        QVERIFY(!workspace.save(QStringLiteral("BALL1"), m_lab.tasks[0].solution));
        QVERIFY(!workspace.save(QStringLiteral("BALL2"),
                                QStringLiteral("function on_update() x.y = 1 end\n")));
        const QString mistake = m_lab.tasks[0].mistakes.front().name;
        for (int i = 0; i < 2; ++i)
            QVERIFY(!workspace.keep(
                QStringLiteral("BALL1"), m_lab.tasks[0].mistakes.front().source,
                {.reason = VersionReason::Checked, .passed = false, .findings = {mistake}}));
        QVERIFY(!workspace.keep(QStringLiteral("BALL1"), m_lab.tasks[0].solution,
                                {.reason = VersionReason::Checked, .passed = true}));
        QVERIFY(!workspace.saveNote(QStringLiteral("BALL1"), QStringLiteral("It *fell* <b>.")));
        QVERIFY(!workspace.setStudent(QStringLiteral("Ada Lovelace"), QStringLiteral("s1")));
    }

    [[nodiscard]] HandIn gathered() const
    {
        const auto handIn =
            gatherHandIn(m_lab, path("w"), {.note = QStringLiteral("Dear teacher")}, 1, m_when);
        if (!handIn)
            qFatal("%s", qPrintable(handIn.error().toString()));
        return *handIn;
    }
    [[nodiscard]] QByteArray packed() const { return *packHandIn(gathered(), reportName, "%PDF"); }

    static inline const QString reportName = QStringLiteral("report.pdf");
    const QDateTime m_when{QDate(2026, 11, 22), QTime(10, 0), Qt::UTC};
    Lab m_lab;
};

} // namespace cradle
