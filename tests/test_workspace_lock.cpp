// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace_lock.h"
#include "tests/text.h"

#include "model/files/file_io.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace cradle;

/// The file that says who may write in a workspace.
class TestWorkspaceLock : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void whoIsAliveHoldsIt_data();
    void whoIsAliveHoldsIt();
    void itIsTakenOnceAndGivenBack();
    void whoMovesItHoldsItStill();
    void whoTakesItOverHoldsIt();
    void whereNothingCanBeWrittenNobodyHoldsIt();

private:
    [[nodiscard]] QString path() const { return m_folder->filePath(QLatin1String(lockFileName)); }
    [[nodiscard]] QJsonObject written() const
    {
        QFile file(path());
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    }

    std::unique_ptr<QTemporaryDir> m_folder{};
};

void TestWorkspaceLock::whoIsAliveHoldsIt_data()
{
    QTest::addColumn<QJsonObject>("file");
    QTest::addColumn<bool>("holds");
    const QString here = QSysInfo::machineHostName();
    const qint64 own = QCoreApplication::applicationPid();
    const auto row = [](const char *name, const QString &host, qint64 process, qint64 start,
                        const char *token, bool holds) {
        QTest::newRow(name) << QJsonObject{{text("host"), host},
                                           {text("process"), process},
                                           {text("start"), start},
                                           {text("since"), text("2026-05-04T03:02:01Z")},
                                           {text("token"), text(token)}}
                            << holds;
    };
    row("alive, of a time that is not told", here, own, 0, "x", true);
    row("alive, but begun at another time", here, own, 1, "x", false);
    row("the first process of all", here, 1, 0, "x", true);
    row("no process", here, 0, 0, "x", false);
    row("all processes of a group", here, -1, 0, "x", false);
    row("no such process", here, 99'999'999, 0, "x", false);
    row("another machine", text("elsewhere"), 99'999'999, 0, "x", true);
    row("another machine, no token", text("elsewhere"), own, 0, "", false);
    QTest::newRow("nothing told") << QJsonObject() << false;
}

void TestWorkspaceLock::whoIsAliveHoldsIt()
{
    QFETCH(QJsonObject, file);
    QFETCH(bool, holds);
    QVERIFY(!writeFile(path(), QJsonDocument(file).toJson()));
    WorkspaceLock lock(m_folder->path());
    const auto holder = lock.take();
    QCOMPARE(holder.has_value(), holds);
    QCOMPARE(lock.isHeld(), !holds);
    const QDateTime since =
        QDateTime::fromString(file.value(text("since")).toString(), Qt::ISODate);
    if (holds) {
        QCOMPARE(holder->host, file.value(text("host")).toString());
        QCOMPARE(holder->process, file.value(text("process")).toInteger());
        QCOMPARE(holder->since, since);
        QCOMPARE(holder->token, text("x"));
        QCOMPARE(written(), file);
        QVERIFY(!lock.killedSince().isValid());
    } else {
        QCOMPARE(lock.killedSince(), since);
    }
    // Nothing else lies there.
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden),
             QStringList{QLatin1String(lockFileName)});
}

void TestWorkspaceLock::itIsTakenOnceAndGivenBack()
{
    {
        WorkspaceLock lock(m_folder->path());
        QVERIFY(!lock.isHeld());
        QVERIFY(!lock.take());
        const QJsonObject first = written();
        QCOMPARE(first.value(text("host")).toString(), QSysInfo::machineHostName());
        QCOMPARE(first.value(text("process")).toInteger(), QCoreApplication::applicationPid());
        QVERIFY(first.value(text("start")).toInteger() > 0);
        QVERIFY(!lock.take()); // again
        QCOMPARE(written(), first);
        WorkspaceLock other(m_folder->path());
        QVERIFY(other.take() && !other.isHeld());
    } // the other one takes nothing away, the first one does
    QVERIFY(!QFile::exists(path()));
}

void TestWorkspaceLock::whoMovesItHoldsItStill()
{
    QVERIFY(!writeFile(path(), "{\"since\": \"2026-05-04T03:02:01Z\"}"));
    WorkspaceLock first(m_folder->path());
    QVERIFY(!first.take());
    WorkspaceLock second(std::move(first));
    QVERIFY(second.isHeld() && second.killedSince().isValid());
    WorkspaceLock third;
    QVERIFY(!third.isHeld());
    third = std::move(second);
    QVERIFY(third.isHeld() && third.killedSince().isValid());
    const QTemporaryDir elsewhere;
    WorkspaceLock fourth(elsewhere.path());
    QVERIFY(!fourth.take());
    third = std::move(fourth); // which gives back what it had
    QVERIFY(third.isHeld() && !QFile::exists(path()));
    QVERIFY(!third.killedSince().isValid());
}

void TestWorkspaceLock::whoTakesItOverHoldsIt()
{
    WorkspaceLock first(m_folder->path());
    QVERIFY(!first.take());
    {
        WorkspaceLock second(m_folder->path());
        second.takeOver();
        QVERIFY(second.isHeld() && !first.isHeld());
        first = WorkspaceLock(); // it may not take away what is another's
        QVERIFY(second.isHeld());
    }
    QVERIFY(!QFile::exists(path()));
}

void TestWorkspaceLock::whereNothingCanBeWrittenNobodyHoldsIt()
{
    WorkspaceLock lock(m_folder->filePath(text("nowhere")));
    QVERIFY(!lock.take());
    QVERIFY(!lock.isHeld());
    lock.takeOver();
    QVERIFY(!lock.isHeld());
}

QTEST_GUILESS_MAIN(TestWorkspaceLock)
#include "test_workspace_lock.moc"
