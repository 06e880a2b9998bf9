// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_session.h"

#include "code_in_folder.h"
#include "git_folder_test.h"
#include "model/files/file_io.h"
#include "tests/patience.h"

#include <QSignalSpy>
#include <QTest>

using namespace cradle;

/// What the program of a step was is kept as versions, whoever replaces it.
class TestCodeVersions final : public GitFolderTest
{
    Q_OBJECT
private slots:
    void init() { takeNewFolder(); }
    void someMinutesOfTypingKeepAVersion();
    void leavingAStepKeepsAVersion();
    void replacingKeepsAVersion();
    void outsideEditIsTaken();
    void outsideEditWhileTypingIsKept();
};

void TestCodeVersions::someMinutesOfTypingKeepAVersion()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    session.setKeepDelay(std::chrono::milliseconds(1));
    open(session, path());
    const auto versions = [&] {
        return session.workspace().history()->versions(QStringLiteral("A"));
    };
    // What is not changed makes none.
    QTest::qWait(20);
    QVERIFY(versions().empty());
    for (std::size_t count = 1; count <= 3; ++count) {
        session.edit(QStringLiteral("-- %1\n").arg(count));
        QTRY_COMPARE(versions().size(), count);
        QCOMPARE(versions()[0].note.reason, VersionReason::Typed);
        QVERIFY(!versions()[0].note.passed);
        QCOMPARE(*session.workspace().history()->textOf(versions()[0]),
                 QByteArray("-- %1\n").replace("%1", QByteArray::number(qulonglong(count))));
    }
}

void TestCodeVersions::leavingAStepKeepsAVersion()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.open(twoSteps(), 1);
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(versions.size(), std::size_t(1));
    QCOMPARE(versions[0].note.reason, VersionReason::Typed);
    // Nothing was changed since.
    session.open(twoSteps(), 0);
    session.open(twoSteps(), 1);
    QCOMPARE(session.workspace().history()->versions(QStringLiteral("A")).size(), std::size_t(1));
}

void TestCodeVersions::replacingKeepsAVersion()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.replace(QStringLiteral("-- other\n"));
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(versions.size(), std::size_t(1));
    QCOMPARE(*session.workspace().history()->textOf(versions[0]), QByteArray("-- mine\n"));
    QCOMPARE(session.text(), QStringLiteral("-- other\n"));
}

void TestCodeVersions::outsideEditIsTaken()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    QSignalSpy outside(&session, &CodeSession::changedOutside);
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- theirs\n"));
    QTRY_COMPARE(outside.size(), 1);
    QVERIFY(outside[0][0].toBool());
    QCOMPARE(session.text(), QStringLiteral("-- theirs\n"));
    QCOMPARE(content(path("w/lab.lua")), QByteArray("-- theirs\n"));
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(versions.size(), std::size_t(2));
    QCOMPARE(*session.workspace().history()->textOf(versions[1]), QByteArray("-- mine\n"));
}

void TestCodeVersions::outsideEditWhileTypingIsKept()
{
    Simulation simulation{Preset{}};
    CodeSession session(simulation);
    open(session, path());
    session.edit(QStringLiteral("-- mine\n"));
    session.save();
    session.edit(QStringLiteral("-- mine, and more\n"));
    QVERIFY(!writeFile(path("w/steps/A.lua"), "-- theirs\n"));
    QSignalSpy outside(&session, &CodeSession::changedOutside);
    session.save();
    QCOMPARE(outside.size(), 1);
    QVERIFY(!outside[0][0].toBool());
    QCOMPARE(content(path("w/steps/A.lua")), QByteArray("-- mine, and more\n"));
    const auto versions = session.workspace().history()->versions(QStringLiteral("A"));
    QCOMPARE(*session.workspace().history()->textOf(versions.front()), QByteArray("-- theirs\n"));
}

QTEST_GUILESS_MAIN(TestCodeVersions)
#include "test_code_versions.moc"
