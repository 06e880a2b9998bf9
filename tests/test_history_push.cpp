// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/history.h"

#include "history_test.h"
#include "model/files/file_io.h"

#include <QTest>

using namespace cradle;

/// The history goes where the student pushes or bundles it.
class TestHistoryPush final : public HistoryTest
{
    Q_OBJECT
private slots:
    void init() { writeProgram(); }
    void pushesToABareRepository();
    void lastPushIsOfTheBranchThatIsOut();
    void saysWhatKeepsItFromPushing();
    void bundleCanBeCloned();
};

void TestHistoryPush::pushesToABareRepository()
{
    QCOMPARE(gitAround({QStringLiteral("init"), QStringLiteral("-q"), QStringLiteral("--bare"),
                        QStringLiteral("b.git")}),
             QString());
    const auto history = opened();
    QVERIFY(!history->commit(QStringLiteral("Begin\n"), student));
    QVERIFY(!history->keep(task, "-- two\n", checked(false), student));
    QVERIFY(history->remoteUrl().isEmpty());
    QVERIFY(!history->setRemoteUrl(path("b.git")));
    QCOMPARE(history->remoteUrl(), path("b.git"));
    QVERIFY(!history->lastPush().isValid());
    const auto error = history->push();
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
    QVERIFY(history->lastPush().isValid());
    const QString there = GitHome::git(
        path("b.git"), {QStringLiteral("for-each-ref"), QStringLiteral("--format=%(refname)")});
    QCOMPARE(there, QStringLiteral("refs/cradle/versions/L42T5\nrefs/heads/main"));
    QVERIFY(!history->setRemoteUrl({}));
    QVERIFY(history->remoteUrl().isEmpty());
}

void TestHistoryPush::lastPushIsOfTheBranchThatIsOut()
{
    QCOMPARE(gitAround({QStringLiteral("init"), QStringLiteral("-q"), QStringLiteral("--bare"),
                        QStringLiteral("bare")}),
             QString());
    QCOMPARE(git(QStringLiteral("init -q -b trunk .")), QString());
    const auto history = opened();
    QVERIFY(history);
    QVERIFY(!history->commit(QStringLiteral("Begin\n"), student));
    QVERIFY(!history->setRemoteUrl(path("bare")));
    QVERIFY(!history->lastPush().isValid());
    const auto error = history->push();
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
    QVERIFY(history->lastPush().isValid());
}

void TestHistoryPush::saysWhatKeepsItFromPushing()
{
    const auto history = opened();
    QVERIFY(!history->commit(QStringLiteral("Begin\n"), student));
    QVERIFY(history->push());
    QVERIFY(!history->setRemoteUrl(path("nowhere.git")));
    const auto error = history->push();
    QVERIFY(error);
    QCOMPARE(error->file, path("nowhere.git"));
    QVERIFY2(error->message.contains(QLatin1String("there is no git repository at this address")),
             qPrintable(error->message));
    QVERIFY(!history->setRemoteUrl(QStringLiteral("my work")));
    QVERIFY(history->push()->message.contains(QLatin1String("no address of a git repository")));
    // Somebody else's work is there.
    gitAround({QStringLiteral("init"), QStringLiteral("-q"), QStringLiteral("--bare"),
               QStringLiteral("b.git")});
    QVERIFY(!makeFolder(path("other")));
    auto other = History::open(path("other"));
    QVERIFY(other && !writeFile(path("other/lab.lua"), "-- theirs\n"));
    QVERIFY(!(*other)->commit(QStringLiteral("Theirs\n"), student));
    QVERIFY(!(*other)->setRemoteUrl(path("b.git")) && !(*other)->push());
    QVERIFY(!history->setRemoteUrl(path("b.git")));
    const auto refused = history->push();
    QVERIFY(refused);
    QVERIFY2(refused->message.contains(QLatin1String("other work")), qPrintable(refused->message));
}

void TestHistoryPush::bundleCanBeCloned()
{
    const auto history = opened();
    QVERIFY(!history->commit(QStringLiteral("Begin\n"), student));
    QVERIFY(!history->keep(task, "-- two\n", checked(false), student));
    const auto bundle = history->bundle();
    QVERIFY(bundle);
    QVERIFY(!writeFile(path("h.bundle"), *bundle));
    const QString said = gitAround({QStringLiteral("clone"), QStringLiteral("-q"),
                                    QStringLiteral("h.bundle"), QStringLiteral("cloned")});
    QVERIFY2(!said.startsWith(QLatin1String("failed")), qPrintable(said));
    QFile file(path("cloned/steps/L42T5.lua"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("-- one\n"));
    QVERIFY(History::openExisting(path("cloned")));
    QVERIFY(gitAround({QStringLiteral("ls-remote"), QStringLiteral("h.bundle")})
                .contains(QLatin1String("refs/cradle/versions/L42T5")));
}

QTEST_GUILESS_MAIN(TestHistoryPush)
#include "test_history_push.moc"
