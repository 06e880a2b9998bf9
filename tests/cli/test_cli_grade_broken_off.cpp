// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"
#include "tests/patience.h"
#include "tests/sanitized.h"

#include <QStandardPaths>

#include <algorithm>
#include <csignal>

#include <unistd.h>

using namespace cradle::programs;

/// cradle-cli grade against kills.
class TestCliGradeBrokenOff : public QObject
{
    Q_OBJECT
private slots:
    void killedGraderGoesOnWhereItWas();
    void killedWorkersCostNoVerdict();
    void killsInALoopLoseAndDoubleNothing();
    void stoppedGraderLeavesNoWorkers();
    void graderKilledWhileBubblewrapStartsLeavesNothing();
    void killedBubblewrapLeavesNobodyWaiting();
    void killedGuardLeavesNobodyWaiting_data();
    void killedGuardLeavesNobodyWaiting();
    void stopIsCleanAndResumable();
};

namespace {

/// The processes that \p ancestor started, and those that they did.
std::vector<pid_t> descendantsOf(qint64 ancestor)
{
    QMap<qint64, qint64> parents;
    for (const QString &name : QDir(text("/proc")).entryList(QDir::Dirs)) {
        bool isNumber = false;
        const qint64 pid = name.toLongLong(&isNumber);
        if (!isNumber)
            continue;
        const QString stat = QString::fromUtf8(contentOf(text("/proc/") + name + text("/stat")));
        parents[pid] = stat.mid(stat.lastIndexOf(u')') + 2).section(u' ', 1, 1).toLongLong();
    }
    std::vector<pid_t> found;
    for (auto it = parents.begin(); it != parents.end(); ++it) {
        for (qint64 up = *it; up > 1; up = parents.value(up)) {
            if (up == ancestor) {
                found.push_back(static_cast<pid_t>(it.key()));
                break;
            }
        }
    }
    return found;
}

bool isThere(pid_t pid)
{
    const QString stat =
        QString::fromUtf8(contentOf(text("/proc/") + QString::number(pid) + text("/stat")));
    return !stat.isEmpty() && stat.mid(stat.lastIndexOf(u')') + 2).at(0) != u'Z';
}

/// How many of them are ours.
std::ptrdiff_t judging(const std::vector<pid_t> &processes)
{
    return std::count_if(processes.begin(), processes.end(), [](pid_t pid) {
        return contentOf(text("/proc/") + QString::number(pid) + text("/comm"))
            .startsWith("cradle-cli");
    });
}

int resultsIn(const GradedClass &made, const QString &out)
{
    return static_cast<int>(
        QDir(made.at(out + text("/students"))).entryList({text("*.json")}, QDir::Files).size());
}

void fill(const GradedClass &made, int count)
{
    for (int i = 0; i < count; ++i)
        made.putStudent(QStringLiteral("student%1").arg(i, 2, 10, QLatin1Char('0')));
}

/// An environment where bubblewrap is a script of ours.
QProcessEnvironment withBubblewrap(const GradedClass &made, const QByteArray &script)
{
    const QString path = made.at(text("bin/bwrap"));
    made.put(text("bin/bwrap"), "#!/bin/sh\n" + script);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(text("PATH"), made.at(text("bin")) + u':' + environment.value(text("PATH")));
    return environment;
}

} // namespace

/// Killed after every student or two, it comes to the same end, byte for byte.
void TestCliGradeBrokenOff::killedGraderGoesOnWhereItWas()
{
    const GradedClass made;
    fill(made, 8);
    VERIFY_CODE(made.grade(text("whole")), 1);
    int kills = 0;
    for (int before = 0; before < 8;) {
        QProcess process;
        process.start(cradle::cliProgram(), made.arguments(text("out")));
        QVERIFY(process.waitForStarted());
        while (resultsIn(made, text("out")) <= before && process.state() != QProcess::NotRunning)
            QVERIFY(!process.waitForFinished(1) || process.exitStatus() == QProcess::NormalExit);
        process.kill();
        process.waitForFinished(patience);
        const int now = resultsIn(made, text("out"));
        QVERIFY(now >= before);
        before = now > before ? now : 8;
        ++kills;
    }
    QVERIFY(kills > 1);
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.differing(text("out"), text("whole")), QStringList());
}

void TestCliGradeBrokenOff::killedWorkersCostNoVerdict()
{
    const GradedClass made;
    fill(made, 6);
    VERIFY_CODE(made.grade(text("whole")), 1);
    QProcess process;
    process.start(cradle::cliProgram(), made.arguments(text("out"), {text("--jobs"), text("2")}));
    QVERIFY(process.waitForStarted());
    for (int kills = 0; kills < 4 && process.state() != QProcess::NotRunning;) {
        const auto workers = descendantsOf(process.processId());
        if (!workers.empty()) { // the youngest: a worker, or who forks them
            kill(workers.back(), SIGKILL);
            ++kills;
        }
        process.waitForFinished(30);
    }
    QVERIFY(process.waitForFinished(patience));
    QCOMPARE(process.exitCode(), 1);
    QCOMPARE(made.differing(text("out"), text("whole")), QStringList());
}

/// Now the grader is killed, now a worker or who forks them, at ever other moments. What stands in
/// the results at any time is whole and right, and so is the end.
void TestCliGradeBrokenOff::killsInALoopLoseAndDoubleNothing()
{
    const GradedClass made;
    fill(made, 10);
    VERIFY_CODE(made.grade(text("whole")), 1);
    const auto right = made.files(text("whole/students"));
    for (int kills = 0; kills < 24; kills += cradle::oneOf(2)) {
        QProcess process;
        process.start(cradle::cliProgram(),
                      made.arguments(text("out"), {text("--jobs"), text("3")}));
        QVERIFY(process.waitForStarted());
        process.waitForFinished(10 + kills * 37 % 150);
        if (kills % 3 != 0) {
            const auto workers = descendantsOf(process.processId());
            if (!workers.empty())
                kill(workers[static_cast<std::size_t>(kills) % workers.size()], SIGKILL);
            process.waitForFinished(5 + kills * 13 % 60);
        }
        process.kill();
        process.waitForFinished(patience);
        const auto there = made.files(text("out/students"));
        for (auto it = there.begin(); it != there.end(); ++it) {
            if (right.contains(it.key())) // else one that was being written, beside its name
                QVERIFY2(*it == right[it.key()], it.key().toUtf8());
        }
    }
    VERIFY_CODE(made.grade(text("out")), 1);
    const QStringList differing = made.differing(text("out"), text("whole"));
    QVERIFY2(differing.isEmpty(), differing.join(u' ').toUtf8());
    QCOMPARE(made.json(text("out/manifest.json")).value(text("students")).toArray().size(), 10);
}

void TestCliGradeBrokenOff::stoppedGraderLeavesNoWorkers()
{
    const GradedClass made;
    made.putProgram(text("ada"), text("BALL1"), "function on_update(dt) for i = 1, 2e5 do end end");
    for (const char *step : {"BALL2", "BALL3"})
        made.putProgram(text("ada"), text(step), GradedClass::solution(step));
    QProcess process;
    process.start(cradle::cliProgram(), made.arguments(text("out")));
    QVERIFY(process.waitForStarted());
    std::vector<pid_t> workers;
    while (judging(workers) < 2 && !process.waitForFinished(1))
        workers = descendantsOf(process.processId());
    process.kill();
    process.waitForFinished(patience);
    for (const pid_t worker : workers)
        QTRY_VERIFY(!isThere(worker));
    QCOMPARE(resultsIn(made, text("out")), 0);
}

/// What bubblewrap starts waits for it. Here it does so for ever, at the worst of moments.
void TestCliGradeBrokenOff::graderKilledWhileBubblewrapStartsLeavesNothing()
{
    const GradedClass made;
    fill(made, 1);
    const QString note = made.at(text("note"));
    QProcess process;
    process.setProcessEnvironment(withBubblewrap(
        made, "sleep infinity &\necho $$ $! > '" + note.toUtf8() + "'\nsleep infinity\n"));
    process.start(cradle::cliProgram(), made.arguments(text("out")));
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(contentOf(note).endsWith('\n'));
    const QByteArrayList started = contentOf(note).trimmed().split(' ');
    QCOMPARE(started.size(), 2);
    const auto all = descendantsOf(process.processId());
    QVERIFY(all.size() >= 3);
    process.kill();
    process.waitForFinished(patience);
    for (const pid_t one : all)
        QTRY_VERIFY(!isThere(one));
    for (const QByteArray &one : started)
        QTRY_VERIFY(!isThere(static_cast<pid_t>(one.toInt())));
}

/// The first is killed, and what it has started keeps the line to the grader open.
void TestCliGradeBrokenOff::killedBubblewrapLeavesNobodyWaiting()
{
    const GradedClass made;
    fill(made, 2);
    VERIFY_CODE(made.grade(text("whole")), 1);
    const QByteArray note = made.at(text("note")).toUtf8();
    const QString real = QStandardPaths::findExecutable(text("bwrap"));
    QProcess process;
    process.setProcessEnvironment(withBubblewrap(
        made, "if [ ! -e '" + note + "' ]; then\nsleep infinity &\necho $! > '" + note
                  + "'\nkill -9 $$\nfi\nexec '" + QFile::encodeName(real) + "' \"$@\"\n"));
    process.start(cradle::cliProgram(), made.arguments(text("out")));
    QVERIFY(process.waitForFinished(patience));
    QCOMPARE(process.exitCode(), 1);
    QCOMPARE(made.differing(text("out"), text("whole")), QStringList());
    const auto waiting = static_cast<pid_t>(contentOf(made.at(text("note"))).trimmed().toInt());
    QVERIFY(waiting > 0);
    QTRY_VERIFY(!isThere(waiting));
}

void TestCliGradeBrokenOff::killedGuardLeavesNobodyWaiting_data()
{
    QTest::addColumn<int>("kills");
    QTest::newRow("once") << 1;
    QTest::newRow("whenever it starts") << 100;
}

/// Who watches bubblewrap is killed by it. What is left holds the lines to the grader open, reads
/// nothing and says nothing; nobody waits for it, and it ends, too.
void TestCliGradeBrokenOff::killedGuardLeavesNobodyWaiting()
{
    QFETCH(int, kills);
    const GradedClass made;
    made.putStudent(text("ada"));
    const QByteArray note = QFile::encodeName(made.at(text("note")));
    QProcess process;
    process.setProcessEnvironment(withBubblewrap(
        made, "touch '" + note + "'\n[ $(wc -l < '" + note + "') -lt " + QByteArray::number(kills)
                  + " ] || exit 1\nsleep infinity &\necho $! >> '" + note
                  + "'\nkill -9 $PPID\nsleep infinity\n"));
    process.start(cradle::cliProgram(), made.arguments(text("out")));
    QVERIFY(process.waitForFinished(patience));
    QCOMPARE(process.exitCode(), 1);
    QCOMPARE(made.verdicts(text("out"), text("ada")),
             (QStringList{text("passed"), text("failed"), text("missing")}));
    const QByteArrayList left = contentOf(made.at(text("note"))).trimmed().split('\n');
    QCOMPARE(left.size(), std::min(kills, 5)); // so often it is tried
    for (const QByteArray &one : left)
        QTRY_VERIFY(!isThere(static_cast<pid_t>(one.toInt())));
}

void TestCliGradeBrokenOff::stopIsCleanAndResumable()
{
    const GradedClass made;
    fill(made, 8);
    VERIFY_CODE(made.grade(text("whole")), 1);
    QProcess process;
    process.start(cradle::cliProgram(), made.arguments(text("out"), {text("--jobs"), text("1")}));
    QVERIFY(process.waitForStarted());
    while (resultsIn(made, text("out")) == 0)
        process.waitForFinished(1);
    kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(patience));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(!made.json(text("out/manifest.json")).value(text("complete")).toBool(true));
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.differing(text("out"), text("whole")), QStringList());
}

QTEST_GUILESS_MAIN(TestCliGradeBrokenOff)
#include "test_cli_grade_broken_off.moc"
