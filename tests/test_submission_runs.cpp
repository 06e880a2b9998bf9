// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

using namespace cradle;

class TestSubmissionRuns : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void sameSceneRunsOnce();
    void stoppedRunIsMadeAgain();
    void runThatTakesTooMuchEndsWhereItWould();
    void reportsAreThoseOfSingleJudgements_data();
    void reportsAreThoseOfSingleJudgements();

private:
    [[nodiscard]] const Task &task(const char *id) const
    {
        return m_lab.tasks[static_cast<std::size_t>(m_lab.indexOf(QLatin1String(id)))];
    }

    Lab m_lab;
};

void TestSubmissionRuns::initTestCase()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

void TestSubmissionRuns::sameSceneRunsOnce()
{
    const Task &step = task("L42T11");
    const Submission submission(step.preset, step.solution);
    SubmissionRuns runs(submission);
    int asked = 0; // before every step, and while the program runs
    const auto count = [&asked] {
        ++asked;
        return false;
    };
    const Variant scene{.name = QStringLiteral("preset"), .preset = step.preset, .duration = 1.0};
    const Observation first = runs.of(scene, count);
    const int steps = asked;
    QVERIFY(steps >= first.steps());
    const Observation &again = runs.of(scene, count);
    QCOMPARE(asked, steps);
    QCOMPARE(again.steps(), first.steps());
    for (qint64 k = 0; k <= first.steps(); ++k)
        QVERIFY(again.circle(0, k) == first.circle(0, k));

    Variant longer = scene;
    longer.duration = 2.0;
    QVERIFY(runs.of(longer, count).steps() > first.steps());
    Variant pinned = scene;
    pinned.pinned = true;
    const int before = asked;
    runs.of(pinned, count);
    QCOMPARE(asked, before + steps);
}

void TestSubmissionRuns::stoppedRunIsMadeAgain()
{
    const Task &step = task("L42T11");
    const Submission submission(step.preset, step.solution);
    SubmissionRuns runs(submission);
    const Variant scene{.name = QStringLiteral("preset"), .preset = step.preset, .duration = 1.0};
    int left = 10;
    const qint64 cut = runs.of(scene, [&left] { return left-- == 0; }).steps();
    QVERIFY(cut > 0 && cut <= 10);
    QVERIFY(runs.of(scene, [] { return false; }).steps() > 10);
}

void TestSubmissionRuns::runThatTakesTooMuchEndsWhereItWould()
{
    const Task &step = task("L42T11");
    // The work of a loop like this is not bounded by its text, so every instruction is counted.
    const Submission submission(step.preset,
                                step.solution + QStringLiteral("\nwhile step < 0 do end\n"));
    const Variant scene{.name = QStringLiteral("preset"), .preset = step.preset, .duration = 1.0};
    const auto goOn = [] { return false; };
    SubmissionRuns fresh(submission);
    const qint64 all = SubmissionRuns(submission).of(scene, goOn).instructions;
    const qint64 cutSteps = fresh.of(scene, goOn, all / 2).steps();
    QVERIFY(cutSteps > 0);
    const qint64 allSteps = fresh.of(scene, goOn, all).steps();
    QVERIFY(cutSteps < allSteps);
    // What is known whole is not what little is allowed would have seen.
    QCOMPARE(fresh.of(scene, goOn, all / 2).steps(), cutSteps);
    QCOMPARE(fresh.of(scene, goOn).steps(), allSteps);
}

void TestSubmissionRuns::reportsAreThoseOfSingleJudgements_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("source");
    for (const char *id : {"L42T3", "L42T11"}) {
        const Task &step = task(id);
        QTest::addRow("%s solution", id) << step.id << step.solution;
        QTest::addRow("%s mistake", id) << step.id << step.mistakes.front().source;
    }
}

void TestSubmissionRuns::reportsAreThoseOfSingleJudgements()
{
    QFETCH(QString, step);
    QFETCH(QString, source);
    const Task &judged = task(step.toLatin1().constData());
    const Submission submission(judged.preset, source);
    SubmissionRuns runs(submission);
    for (const qint64 seed : {1, 2, 3}) {
        CheckReport shared = *judgeTask(m_lab, judged, runs, seed);
        CheckReport alone = *judgeTask(m_lab, judged, submission, seed);
        shared.elapsedMs = alone.elapsedMs = 0;
        QVERIFY(shared == alone);
        QCOMPARE(shared.passed, source == judged.solution);
    }
}

QTEST_MAIN(TestSubmissionRuns)
#include "test_submission_runs.moc"
