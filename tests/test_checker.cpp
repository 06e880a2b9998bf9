// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/checker.h"

#include "model/files/preset_json.h"
#include "tasks/reading/lab_reader.h"
#include "tests/patience.h"

#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>

using namespace cradle;

class TestChecker : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void reportIsReproducible_data();
    void reportIsReproducible();
    void reportNamesWhatWasJudged();
    void submissionIsNotJudgedByItsValuesWherePinned();
    void missingCircleIsSaid_data();
    void missingCircleIsSaid();
    void progressCountsEveryScene();
    void cancelledJudgementHasNoReport();
    void finishesOffThisThread();
    void cancelIsFollowedByNothing();
    void progressEndsWithTheCancel();
    void cancelAfterTheWorkIsDoneIsFollowedByNothing();
    void cancelWithNothingRunningIsSilent();
    void newStartReplacesTheOldOne();
    void goingAwayWhileItRunsIsSafe();
    void heavyScenesAreJudgedOrRefused_data();
    void heavyScenesAreJudgedOrRefused();

private:
    [[nodiscard]] const Task &task(const char *id) const;
    [[nodiscard]] Preset solution(const char *id) const;

    Lab m_lab;
};

namespace {

/// Everything but the time that it took.
CheckReport timeless(CheckReport report)
{
    report.elapsedMs = 0;
    return report;
}

} // namespace

void TestChecker::initTestCase()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

const Task &TestChecker::task(const char *id) const
{
    return m_lab.tasks[static_cast<std::size_t>(m_lab.indexOf(QLatin1String(id)))];
}

Preset TestChecker::solution(const char *id) const
{
    return *readPreset(task(id).folder + QStringLiteral("/solution-preset.json"));
}

void TestChecker::reportIsReproducible_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("passes") << QStringLiteral("/solution-preset.json");
    QTest::newRow("fails") << QStringLiteral("/preset.json");
}

void TestChecker::reportIsReproducible()
{
    QFETCH(QString, preset);
    for (const char *id : {"L42T2", "L42T12", "L42T16"}) {
        const Preset submission = *readPreset(task(id).folder + preset);
        const CheckReport first = *judgeTask(m_lab, task(id), submission, 42);
        const CheckReport again = *judgeTask(m_lab, task(id), submission, 42);
        QVERIFY(timeless(first) == timeless(again));
    }
}

void TestChecker::reportNamesWhatWasJudged()
{
    const CheckReport report = *judgeTask(m_lab, task("L42T5"), solution("L42T5"), 9);
    QCOMPARE(report.labId, QStringLiteral("lab-4.2"));
    QCOMPARE(report.labHash, m_lab.hash);
    QCOMPARE(report.taskId, QStringLiteral("L42T5"));
    QCOMPARE(report.seed, qint64{9});
    QVERIFY(report.passed);
    QCOMPARE(report.checks.size(), task("L42T5").checks.size());
    for (std::size_t i = 0; i < report.checks.size(); ++i) {
        QCOMPARE(report.checks[i].id, task("L42T5").checks[i].id);
        QCOMPARE(report.checks[i].title, task("L42T5").checks[i].title);
        QVERIFY(report.checks[i].passed && report.checks[i].message.isEmpty());
        QCOMPARE(report.checks[i].step, qint64{-1});
    }
}

void TestChecker::submissionIsNotJudgedByItsValuesWherePinned()
{
    // Without walls the own scene and all others fail, each in the scene where it went wrong.
    Preset open = solution("L42T2");
    open.laws.walls = WallLaw::None;
    const CheckReport report = *judgeTask(m_lab, task("L42T2"), open, 1);
    QVERIFY(!report.passed);
    for (const CheckOutcome &check : report.checks) {
        if (check.passed)
            continue;
        QVERIFY(check.scene && check.step > 0);
        QCOMPARE(check.variant == QLatin1String("preset"), *check.scene == open);
        QCOMPARE(check.id == QLatin1String("walls"), *check.scene == open);
    }
}

void TestChecker::missingCircleIsSaid_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("circles");
    QTest::newRow("none at all") << QStringLiteral("L42T1") << 0;
    QTest::newRow("second of two") << QStringLiteral("L42T4") << 1;
    QTest::newRow("second of an encounter") << QStringLiteral("L42T11") << 1;
    QTest::newRow("none of an encounter") << QStringLiteral("L42T16") << 0;
}

void TestChecker::missingCircleIsSaid()
{
    QFETCH(QString, id);
    QFETCH(int, circles);
    const QByteArray name = id.toLatin1();
    Preset preset = solution(name.constData());
    preset.circles.resize(static_cast<std::size_t>(circles));
    const CheckReport report = *judgeTask(m_lab, task(name.constData()), preset, 1);
    QVERIFY(!report.passed);
    const QString wanted = QStringLiteral("no circle %1").arg(id == QLatin1String("L42T1") ? 1 : 2);
    int said = 0;
    for (const CheckOutcome &check : report.checks) {
        QCOMPARE(check.passed, check.message.isEmpty());
        said += check.message.contains(wanted);
    }
    QVERIFY2(said > 0, qPrintable(wanted));
}

void TestChecker::progressCountsEveryScene()
{
    int last = 0;
    int whole = 0;
    const JudgeHooks hooks{.progress = [&](int done, int total) {
        QCOMPARE(done, last + 1);
        QVERIFY(whole == 0 || whole == total);
        last = done;
        whole = total;
    }};
    QVERIFY(judgeTask(m_lab, task("L42T2"), solution("L42T2"), 1, hooks));
    QCOMPARE(last, whole);
    // 5 scenes of its own, 24 directions for two checks, 12 corners
    QCOMPARE(whole, 5 + 2 * 24 + 12);
    // Scenes that are left out after a fault count as done.
    last = whole = 0;
    QVERIFY(judgeTask(m_lab, task("L42T2"), task("L42T1").preset, 1, hooks));
    QCOMPARE(last, whole);
}

void TestChecker::cancelledJudgementHasNoReport()
{
    int asked = 0;
    const JudgeHooks hooks{.cancelled = [&] { return ++asked == 5; }};
    QVERIFY(!judgeTask(m_lab, task("L42T2"), solution("L42T2"), 1, hooks));
    QCOMPARE(asked, 5);
}

void TestChecker::finishesOffThisThread()
{
    Checker checker;
    QSignalSpy finished(&checker, &Checker::finished);
    QSignalSpy progressed(&checker, &Checker::progressed);
    QSignalSpy cancelled(&checker, &Checker::cancelled);
    checker.start(m_lab, task("L42T11"), solution("L42T11"), 4);
    QVERIFY(finished.isEmpty());
    QTRY_COMPARE(finished.size(), 1);
    QVERIFY(!checker.isRunning());
    QVERIFY(cancelled.isEmpty());
    QVERIFY(!progressed.isEmpty());
    QCOMPARE(progressed.back().at(0).toInt(), progressed.back().at(1).toInt());
    const auto report = finished.front().front().value<CheckReport>();
    QVERIFY(timeless(report) == timeless(*judgeTask(m_lab, task("L42T11"), solution("L42T11"), 4)));
}

void TestChecker::cancelIsFollowedByNothing()
{
    Checker checker;
    QSignalSpy finished(&checker, &Checker::finished);
    QSignalSpy cancelled(&checker, &Checker::cancelled);
    checker.start(m_lab, task("L42T17"), solution("L42T17"), 1);
    checker.cancel();
    QCOMPARE(cancelled.size(), 1);
    QTRY_VERIFY(!checker.isRunning());
    QCoreApplication::processEvents();
    QVERIFY(finished.isEmpty());
    QCOMPARE(cancelled.size(), 1);
}

void TestChecker::progressEndsWithTheCancel()
{
    Checker checker;
    QSignalSpy progressed(&checker, &Checker::progressed);
    checker.start(m_lab, task("L42T17"), solution("L42T17"), 1);
    QTRY_VERIFY(!progressed.isEmpty());
    checker.cancel();
    const auto before = progressed.size();
    QTRY_VERIFY(!checker.isRunning());
    QCoreApplication::processEvents();
    QCOMPARE(progressed.size(), before);
}

void TestChecker::cancelAfterTheWorkIsDoneIsFollowedByNothing()
{
    Checker checker;
    QSignalSpy finished(&checker, &Checker::finished);
    checker.start(m_lab, task("L42T1"), solution("L42T1"), 1);
    // Without events the end of the work is not yet told when it is cancelled.
    QThreadPool::globalInstance()->waitForDone();
    checker.cancel();
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    QVERIFY(finished.isEmpty());
}

void TestChecker::cancelWithNothingRunningIsSilent()
{
    Checker checker;
    QSignalSpy cancelled(&checker, &Checker::cancelled);
    checker.cancel();
    QVERIFY(cancelled.isEmpty());
}

void TestChecker::newStartReplacesTheOldOne()
{
    Checker checker;
    QSignalSpy finished(&checker, &Checker::finished);
    checker.start(m_lab, task("L42T17"), solution("L42T17"), 1);
    checker.start(m_lab, task("L42T12"), solution("L42T12"), 2);
    checker.start(m_lab, task("L42T1"), solution("L42T1"), 3);
    QTRY_COMPARE(finished.size(), 1);
    QTRY_VERIFY(!checker.isRunning());
    QCoreApplication::processEvents();
    QCOMPARE(finished.size(), 1);
    const auto report = finished.front().front().value<CheckReport>();
    QCOMPARE(report.taskId, QStringLiteral("L42T1"));
    QCOMPARE(report.seed, qint64{3});
}

void TestChecker::goingAwayWhileItRunsIsSafe()
{
    {
        Checker checker;
        checker.start(m_lab, task("L42T17"), solution("L42T17"), 1);
    }
    QCoreApplication::processEvents();
}

void TestChecker::heavyScenesAreJudgedOrRefused_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::newRow("many circles") << QByteArray(
        R"({"format": 1, "laws": {"walls": "reflect"},
            "circles": {"fill": {"count": 20000, "radius": 0.005, "rms_speed": 1}}})");
    QTest::newRow("many steps") << QByteArray(
        R"({"format": 1, "timestep": 1e-6, "laws": {"walls": "reflect"},
            "circles": [{"position": [-2, 2], "velocity": [2, 0]}]})");
}

/// A preset that the reader takes may fill more memory than an observation keeps.
void TestChecker::heavyScenesAreJudgedOrRefused()
{
    QFETCH(QByteArray, json);
    const Result<Preset> preset = parsePreset(json);
    QVERIFY(preset.ok());
    const CheckReport report = *judgeTask(m_lab, task("L42T2"), *preset, 1);
    for (const CheckOutcome &check : report.checks) {
        // Nothing lies 4 m beyond a wall here; "-4 m beyond" was read outside the recording.
        QVERIFY2(!check.message.contains(QStringLiteral("is -")), qPrintable(check.message));
        QCOMPARE(check.passed, check.message.isEmpty());
    }
}

QTEST_GUILESS_MAIN(TestChecker)
#include "test_checker.moc"
