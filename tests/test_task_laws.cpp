// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/task_laws.h"

#include "tests/lab_test.h"

using namespace cradle;

/// The laws of a step's own programs: kept for the steps that were judged last, and measured
/// beforehand where that takes no longer than for a sound program.
class TestTaskLaws : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void cleanup() { forgetLaws(); }
    void allIsMeasuredBeforehand();
    void onlyWhatIsAskedIsMeasured();
    void whatTakesLongIsNot_data();
    void whatTakesLongIsNot();
    void lawsAreThoseOfTheStep();
    void twentyStepsAreKept();
    void measuredLawsAreThoseOfTheStepAsItIs();
    void measuringBeforehandChangesNoFinding();
};

namespace {

/// The solution of \p task with \p work passes of an empty loop in each step.
KnownScript working(const Task &task, int work)
{
    QString source = task.solution;
    source += QStringLiteral("\nlocal update = on_update\n"
                             "function on_update(dt)\n"
                             "  for _ = 1, %1 do end\n"
                             "  update(dt)\n"
                             "end\n")
                  .arg(work);
    return {QStringLiteral("works"), source, QStringLiteral("It works.")};
}

} // namespace

void TestTaskLaws::allIsMeasuredBeforehand()
{
    const Task &step = task(QStringLiteral("L42T17"));
    const TaskLaws laws(step);
    QVERIFY(!laws.right().knowsWalls() && !laws.right().knowsPair());
    laws.measureAll();
    QVERIFY(laws.right().knowsWalls() && laws.right().knowsPair());
    std::size_t measured = 0;
    for (std::size_t i = 0; i < step.mistakes.size(); ++i)
        measured += laws.mistake(i).knowsWalls() && laws.mistake(i).knowsPair();
    QVERIFY(measured > 0);
    QCOMPARE(measured, step.mistakes.size());
}

void TestTaskLaws::onlyWhatIsAskedIsMeasured()
{
    const TaskLaws first(task(QStringLiteral("L42T2")));
    first.measureAll();
    QCOMPARE(first.right().knowsWalls(), !first.ground().walls.circles.empty());
    QVERIFY(!first.ground().pair.asked && !first.right().knowsPair());
}

void TestTaskLaws::whatTakesLongIsNot_data()
{
    QTest::addColumn<int>("work");
    QTest::addColumn<bool>("measured");
    // Three steps, of 4000 instructions for each and as many for the start.
    QTest::newRow("none") << 0 << true;
    QTest::newRow("some") << 4'500 << true;
    QTest::newRow("more") << 6'000 << false;
}

void TestTaskLaws::whatTakesLongIsNot()
{
    QFETCH(int, work);
    QFETCH(bool, measured);
    Task step = task(QStringLiteral("L42T2"));
    step.mistakes = {working(step, work)};
    const TaskLaws laws(step);
    laws.measureAll();
    QVERIFY(laws.right().knowsWalls());
    QCOMPARE(laws.mistake(0).knowsWalls(), measured);
}

void TestTaskLaws::lawsAreThoseOfTheStep()
{
    const Task &step = task(QStringLiteral("L42T7"));
    const auto laws = lawsOf(step);
    QVERIFY(laws->areOf(step));
    QCOMPARE(lawsOf(step), laws);
    const auto differs = [&](const std::function<void(Task &)> &change) {
        Task other = step;
        change(other);
        return !laws->areOf(other) && lawsOf(other) != laws;
    };
    QVERIFY(differs([](Task &t) { t.id += u'x'; }));
    QVERIFY(differs([](Task &t) { t.solution += u'\n'; }));
    QVERIFY(differs([](Task &t) { t.preset.gravity.y = -1.0; }));
    QVERIFY(differs([](Task &t) { t.forStudents = !t.forStudents; }));
    QVERIFY(differs([](Task &t) { t.solutionScene = Preset{}; }));
    QVERIFY(differs([](Task &t) { t.mistakes.front().source += u'\n'; }));
    QVERIFY(differs([](Task &t) { t.mistakes.pop_back(); }));
    QVERIFY(differs([](Task &t) { t.checks.pop_back(); }));
}

/// Of those the last asked for.
void TestTaskLaws::twentyStepsAreKept()
{
    Task step;
    step.checks = task(QStringLiteral("L42T2")).checks;
    const auto at = [&](int i) {
        step.id = QString::number(i);
        return lawsOf(step);
    };
    std::vector<std::shared_ptr<const TaskLaws>> all;
    for (int i = 0; i < 20; ++i)
        all.push_back(at(i));
    for (int i = 19; i >= 0; --i)
        QCOMPARE(at(i), all[static_cast<std::size_t>(i)]);
    (void)at(20); // in place of number 19, which was asked for before all others
    QCOMPARE(at(0), all[0]);
    QCOMPARE(at(18), all[18]);
    QVERIFY(at(19) != all[19]);
}

void TestTaskLaws::measuredLawsAreThoseOfTheStepAsItIs()
{
    const Task &step = task(QStringLiteral("L42T3"));
    QCOMPARE(lawsOf(step), lawsOf(step));
    Task changed = step;
    changed.solution += QLatin1Char('\n');
    QVERIFY(lawsOf(changed) != lawsOf(step));
    changed = step;
    changed.mistakes.pop_back();
    QVERIFY(lawsOf(changed) != lawsOf(step));
    changed = step;
    changed.checks.pop_back();
    QVERIFY(lawsOf(changed) != lawsOf(step));
    changed = step;
    changed.preset.gravity.y -= 1.0;
    QVERIFY(lawsOf(changed) != lawsOf(step));
}

void TestTaskLaws::measuringBeforehandChangesNoFinding()
{
    const Task &step = task(QStringLiteral("L42T4"));
    const auto told = [&](const KnownScript &mistake) {
        return judgeTask(m_lab, step, Submission(step.preset, mistake.source), 1,
                         {.provesLines = false})
            ->findings;
    };
    std::vector<std::vector<Finding>> alone;
    for (const KnownScript &mistake : step.mistakes) {
        forgetLaws();
        alone.push_back(told(mistake));
    }
    forgetLaws();
    lawsOf(step)->measureAll();
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const std::vector<Finding> prepared = told(step.mistakes[i]);
        QCOMPARE(prepared.size(), alone[i].size());
        QCOMPARE(prepared.front().mistake, step.mistakes[i].name);
        QCOMPARE(prepared.front().message, alone[i].front().message);
        QCOMPARE(prepared.front().line, alone[i].front().line);
    }
}

QTEST_GUILESS_MAIN(TestTaskLaws)
#include "test_task_laws.moc"
