// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/workers.h"
#include "tasks/reading/lab_reader.h"
#include "tests/test_paths.h"

#include <QFile>
#include <QTest>

#include <csignal>

#include <unistd.h>

using namespace cradle;

/// What is said of a process that judges and does not end by itself.
class TestEndedWorkers : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void whatEndsAWorkerIsTold_data();
    void whatEndsAWorkerIsTold();
};

namespace {

QList<pid_t> childrenOf(pid_t process)
{
    QList<pid_t> children;
    QFile file(QStringLiteral("/proc/%1/task/%1/children").arg(process));
    if (file.open(QIODevice::ReadOnly)) {
        for (const QByteArray &child : file.readAll().split(' ')) {
            if (!child.trimmed().isEmpty())
                children.append(child.toInt());
        }
    }
    return children;
}

/// Ends the process that judges, which the process forks that this one has started.
/// \return whether there is one
bool endWorker(int signal)
{
    for (const pid_t server : childrenOf(getpid())) {
        const QList<pid_t> workers = childrenOf(server);
        if (!workers.isEmpty())
            return ::kill(workers.front(), signal) == 0;
    }
    return false;
}

} // namespace

/// Whatever a program makes of being asked to end, those that it starts end.
void TestEndedWorkers::initTestCase()
{
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
}

void TestEndedWorkers::whatEndsAWorkerIsTold_data()
{
    QTest::addColumn<int>("signal");
    QTest::addColumn<bool>("killed");
    QTest::addColumn<QString>("fault");
    QTest::newRow("a call of the system that judging has no need of")
        << SIGSYS << false << QStringLiteral("it tried what no judgement needs, and was stopped");
    QTest::newRow("processor time")
        << SIGXCPU << false << QStringLiteral("judging took more than 60 s of processor time");
    // QtTest handles those of crashes itself.
    QTest::newRow("another signal")
        << SIGUSR1 << false << QStringLiteral("it was ended by signal 10");
    QTest::newRow("somebody who asks")
        << SIGTERM << false << QStringLiteral("it was ended by signal 15");
    QTest::newRow("somebody at a terminal")
        << SIGINT << false << QStringLiteral("it was ended by signal 2");
    QTest::newRow("somebody") << SIGKILL << true << QStringLiteral("it was ended by signal 9");
}

void TestEndedWorkers::whatEndsAWorkerIsTold()
{
    QFETCH(int, signal);
    QFETCH(bool, killed);
    QFETCH(QString, fault);
    const auto lab = readLab(QLatin1String(bouncingBallLab));
    QVERIFY(lab.ok());
    auto workers = Workers::start(*lab, {}, {}, {}, {});
    QVERIFY(bool(workers));
    const QByteArray program("function on_update(h)\n  for i = 1, 20000 do local x = i end\nend\n");
    const JudgingRequest request{.steps = {QStringLiteral("BALL1")},
                                 .files = {{QStringLiteral("steps/BALL1.lua"), program}}};
    // One that was found too late has ended by itself, and tells a result before.
    std::vector<WorkerEvent> events;
    for (int number = 1; number < 100 && (events.empty() || events.back().done); ++number) {
        events.clear();
        (*workers)->judge(number, request);
        while (events.empty() || events.back().step) {
            endWorker(signal);
            for (WorkerEvent &event : (*workers)->wait(0))
                events.push_back(std::move(event));
        }
    }
    QCOMPARE(events.back().fault, fault);
    QCOMPARE(events.back().killed, killed);
    QCOMPARE((*workers)->busy(), 0);
}

QTEST_GUILESS_MAIN(TestEndedWorkers)
#include "test_ended_workers.moc"
