// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/judgement.h"
#include "tasks/report/report_json.h"
#include "tasks/report/report_text.h"

#include "tests/lab_test.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

using namespace cradle;

/// Who may move the circles, and who did.
class TestMovers : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void stepSaysWhoMayMove_data();
    void stepSaysWhoMayMove();
    void oneCheckSaysThatNothingMoves();
    void programThatDoesNotLoadIsToldThat();
};

namespace {

const QString step = QStringLiteral("L42T2");
/// All that the step asks for, but for a motion.
const QString idle = QStringLiteral("function on_load() circle1.velocity = vec(2, 0) end");

const CheckOutcome &outcome(const CheckReport &report, const char *id)
{
    return *std::find_if(report.checks.begin(), report.checks.end(),
                         [&](const CheckOutcome &c) { return c.id == QLatin1String(id); });
}

} // namespace

void TestMovers::stepSaysWhoMayMove_data()
{
    QTest::addColumn<Mover>("moves");
    QTest::addColumn<int>("program"); ///< none, one without and one with on_update
    QTest::addColumn<bool>("passes");
    QTest::newRow("program: laws alone") << Mover::Program << 0 << true;
    QTest::newRow("program: nothing moves") << Mover::Program << 1 << false;
    QTest::newRow("program: it moves") << Mover::Program << 2 << true;
    QTest::newRow("laws: laws alone") << Mover::Laws << 0 << true;
    QTest::newRow("laws: a program sets values") << Mover::Laws << 1 << true;
    QTest::newRow("laws: a program moves") << Mover::Laws << 2 << false;
    QTest::newRow("either: laws alone") << Mover::Either << 0 << true;
    QTest::newRow("either: a program sets values") << Mover::Either << 1 << true;
    QTest::newRow("either: a program moves") << Mover::Either << 2 << true;
}

void TestMovers::stepSaysWhoMayMove()
{
    QFETCH(Mover, moves);
    QFETCH(int, program);
    QFETCH(bool, passes);
    Task asked = task(step);
    asked.moves = moves;
    Submission submission(solution(step));
    if (program > 0)
        submission.script = program == 1 ? idle : asked.solution;
    const CheckReport report = *judgeTask(m_lab, asked, submission, 1);
    QVERIFY2(report.passed == passes, qPrintable(failedChecks(report)));
    QCOMPARE(report.byProgram, program == 2);
    const QJsonObject json = QJsonDocument::fromJson(writeReport(report)).object();
    QCOMPARE(json.value(QStringLiteral("moved_by")).toString(),
             program == 2 ? QStringLiteral("program") : QStringLiteral("laws"));
    const QString text = describeReport(report);
    QCOMPARE(text.contains(QStringLiteral("The laws of the scene moved the circles.")),
             passes && program < 2);
    QCOMPARE(text.contains(QStringLiteral("The program moved the circles.")),
             passes && program == 2);
}

void TestMovers::oneCheckSaysThatNothingMoves()
{
    const CheckReport report = *judgeTask(m_lab, task(step), Submission(solution(step), idle), 1);
    QCOMPARE(report.checks.size(), task(step).checks.size() + 1);
    QCOMPARE(report.checks.front().id, QStringLiteral("moves"));
    QCOMPARE(report.checks.front().message,
             QStringLiteral("Nothing in your program moves the circles: write on_update"));
    QVERIFY(outcome(report, "start-velocity").passed);
    const CheckOutcome &walls = outcome(report, "walls");
    QVERIFY(!walls.passed);
    QCOMPARE(walls.message, QStringLiteral("not judged: your program does not move the circles"));
    QVERIFY(!report.diagnosis());
}

void TestMovers::programThatDoesNotLoadIsToldThat()
{
    const CheckReport report = *judgeTask(
        m_lab, task(step), Submission(solution(step), QStringLiteral("function on_update(")), 1);
    QVERIFY(report.error);
    QCOMPARE(report.checks.size(), task(step).checks.size());
}

QTEST_GUILESS_MAIN(TestMovers)
#include "test_movers.moc"
