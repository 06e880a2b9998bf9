// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/lab_verifier.h"
#include "tasks/proof/tolerance_margin.h"
#include "tasks/proof/verified_text.h"
#include "tasks/runs/variant.h"

#include <QJsonArray>
#include <QTest>

#include <algorithm>

using namespace cradle;

/// The proof of a lab as a window runs it: findings that a program can read, progress, cancel.
class TestLabVerifier : public QObject
{
    Q_OBJECT
private slots:
    void soundLabHasNoFindings();
    void oneStepIsVerifiedAlone();
    void findingSaysWhatItIsAbout_data();
    void findingSaysWhatItIsAbout();
    void checksThatAddNothingAreNamed();
    void solutionIsJudgedWithEverySeed();
    void progressReachesTheEnd();
    void cancelEndsIt();
    void usedUpToleranceIsMeasured_data();
    void usedUpToleranceIsMeasured();
    void theFirstSceneThatNeedsMostIsNamed();
};

namespace {

const QString still = QStringLiteral("function on_update(dt)\nend\n");
const QString drift =
    QStringLiteral("function on_update(dt)\n"
                   "  circle1.position = circle1.position + circle1.velocity * dt\n"
                   "end\n");
const QString twice =
    QStringLiteral("function on_update(dt)\n"
                   "  circle1.position = circle1.position + 2 * circle1.velocity * dt\n"
                   "end\n");
const QString backwards =
    QStringLiteral("function on_update(dt)\n"
                   "  circle1.position = circle1.position - circle1.velocity * dt\n"
                   "end\n");

/// A circle drifts from (−2, 0) by 1 m in 1 s.
Task soundTask()
{
    Task task;
    task.id = QStringLiteral("S1");
    task.preset.circles.resize(1);
    task.preset.circles[0].body = {.position = {-2, 0}, .velocity = {1, 0}};
    task.starter = still;
    task.solution = drift;
    task.mistakes = {{QStringLiteral("twice"), twice, QStringLiteral("Twice")},
                     {QStringLiteral("backwards"), backwards, QStringLiteral("Backwards")}};
    CheckSpec check;
    check.id = QStringLiteral("drifts");
    check.kind = QStringLiteral("integrates");
    check.circles = {0};
    check.scene = {{QStringLiteral("kind"), QStringLiteral("own")},
                   {QStringLiteral("duration"), 1.0}};
    task.checks = {check};
    return task;
}

Lab labOf(const Task &task)
{
    Lab lab;
    lab.tasks = {task};
    return lab;
}

} // namespace

void TestLabVerifier::oneStepIsVerifiedAlone()
{
    Lab lab = labOf(soundTask());
    lab.tasks.push_back(soundTask());
    lab.tasks.back().id = QStringLiteral("S2");
    QCOMPARE(verifyLab(lab).size(), std::size_t{2});
    const std::vector<VerifiedTask> verified = verifyLab(lab, QStringLiteral("S2"));
    QCOMPARE(verified.size(), std::size_t{1});
    QCOMPARE(verified.front().id, QStringLiteral("S2"));
}

void TestLabVerifier::soundLabHasNoFindings()
{
    const std::vector<VerifiedTask> verified = verifyLab(labOf(soundTask()));
    QCOMPARE(verified.size(), std::size_t{1});
    QVERIFY2(verified.front().findings.empty(), qPrintable(describeVerified(verified.front())));
    QCOMPARE(verified.front().programs.size(), std::size_t{4});
    QCOMPARE(verified.front().programs[1].reports.size(), std::size_t{5});
}

void TestLabVerifier::findingSaysWhatItIsAbout_data()
{
    QTest::addColumn<QString>("change");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("check");
    const auto row = [](const char *change, LabFinding::Kind kind, const char *program,
                        const char *check) {
        QTest::newRow(change) << QString::fromUtf8(change) << static_cast<int>(kind)
                              << QString::fromUtf8(program) << QString::fromUtf8(check);
    };
    using Kind = LabFinding::Kind;
    row("no solution", Kind::NoSolution, "", "");
    row("starter errs", Kind::ProgramErrs, "starter", "drifts");
    row("starter passes", Kind::StarterPasses, "starter", "");
    row("solution fails", Kind::SolutionFails, "solution", "drifts");
    row("mistake passes", Kind::MistakePasses, "mistakes/twice", "");
    row("mistake not recognised", Kind::MistakeNotRecognised, "mistakes/twice", "drifts");
    row("mistake like another", Kind::MistakeTakenForAnother, "mistakes/backwards", "drifts");
    row("mistake has another value", Kind::MistakeDiffersInMore, "mistakes/twice", "");
    row("remark fails", Kind::RemarkFails, "remarks/word", "drifts");
    row("remark not recognised", Kind::RemarkNotRecognised, "remarks/word", "");
    row("check never fails", Kind::CheckNeverFails, "", "start");
    row("check stops", Kind::CheckStops, "starter", "own");
    row("tolerance used up", Kind::ToleranceTooTight, "solution", "end");
}

void TestLabVerifier::findingSaysWhatItIsAbout()
{
    QFETCH(QString, change);
    QFETCH(int, kind);
    QFETCH(QString, program);
    QFETCH(QString, check);
    Task task = soundTask();
    CheckSpec more;
    more.circles = {0};
    more.scene = task.checks[0].scene;
    RemarkSpec word;
    word.script = {QStringLiteral("word"), twice, QStringLiteral("A word")};
    word.scene = task.checks[0].scene;
    if (change == QLatin1String("no solution")) {
        task.solution.clear();
    } else if (change == QLatin1String("starter errs")) {
        task.starter = QStringLiteral("function on_update(dt)\n  error('no')\nend\n");
    } else if (change == QLatin1String("starter passes")) {
        task.starter = drift;
    } else if (change == QLatin1String("solution fails")) {
        task.solution = still;
    } else if (change == QLatin1String("mistake passes")) {
        task.mistakes[0].source = drift;
    } else if (change == QLatin1String("mistake not recognised")) {
        // It goes wrong later than its laws are measured.
        task.mistakes[0].source = QStringLiteral(
            "local count = 0\n"
            "function on_update(dt)\n  count = count + 1\n  local share = count > 10 and 2 or 1\n"
            "  circle1.position = circle1.position + share * circle1.velocity * dt\nend\n");
    } else if (change == QLatin1String("mistake like another")) {
        task.mistakes[1].source = twice;
    } else if (change == QLatin1String("mistake has another value")) {
        task.solution += QStringLiteral("function on_load()\n  restitution = 0.8\nend\n");
        task.mistakes[0].source += QStringLiteral("function on_load()\n  restitution = 0.5\nend\n");
    } else if (change == QLatin1String("remark fails")) {
        task.remarks = {word};
    } else if (change == QLatin1String("remark not recognised")) {
        word.script.source = drift;
        task.remarks = {word};
    } else if (change == QLatin1String("check stops")) {
        // A slip in the line that runs only where something is wrong.
        more.id = QStringLiteral("own");
        more.kind = QStringLiteral("script");
        more.source =
            QStringLiteral("function check(run)\n"
                           "  if math.abs(run:at(1).circles[1].position.x + 1) > 0.1 then\n"
                           "    return false, 'it is ' .. nil\n  end\n  return true\nend\n");
        task.checks.push_back(more);
    } else if (change == QLatin1String("check never fails")) {
        more.id = QStringLiteral("start");
        more.kind = QStringLiteral("start");
        task.checks.push_back(more);
    } else {
        more.id = QStringLiteral("end");
        more.kind = QStringLiteral("ends_at");
        more.parameters = {
            {QStringLiteral("positions"), QJsonArray{QJsonValue(QJsonArray{-1.0007, 0.0})}},
            {QStringLiteral("tolerance"), 1e-3}};
        task.checks.push_back(more);
    }
    const VerifiedTask verified = verifyLab(labOf(task)).front();
    const std::vector<LabFinding> &findings = verified.findings;
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const LabFinding &f) {
        return static_cast<int>(f.kind) == kind;
    });
    QVERIFY2(found != findings.end(),
             findings.empty() ? "nothing" : qPrintable(findings.front().message));
    QCOMPARE(found->task, QStringLiteral("S1"));
    QCOMPARE(found->program, program);
    QCOMPARE(found->check, check);
    QCOMPARE(found->seed, qint64{1});
    QVERIFY(!found->message.isEmpty());
    QVERIFY(describeVerified(verified).contains(QStringLiteral("  ! %1\n").arg(found->message)));
}

void TestLabVerifier::checksThatAddNothingAreNamed()
{
    const auto warningsOf = [](const Task &task) {
        return verifyLab(labOf(task)).front().warnings;
    };
    Task task = soundTask();
    QVERIFY(warningsOf(task).empty());
    // The same circle over a longer time: all that fails there fails here, too.
    CheckSpec longer = task.checks.front();
    longer.id = QStringLiteral("longer");
    longer.scene.insert(QStringLiteral("duration"), 2.0);
    task.checks.push_back(longer);
    std::vector<LabFinding> warnings = warningsOf(task);
    QCOMPARE(warnings.size(), std::size_t{2});
    for (const LabFinding &warning : warnings)
        QCOMPARE(warning.kind, LabFinding::Kind::CheckNeverAlone);
    QCOMPARE(warnings.back().check, QStringLiteral("longer"));
    QVERIFY2(warnings.back().message.endsWith(QStringLiteral("it repeats drifts")),
             qPrintable(warnings.back().message));
    // Something else than the mistakes fails by it alone.
    VerifiedTask verified = verifyLab(labOf(task)).front();
    dropNeeded(verified, {QStringLiteral("longer")});
    QCOMPARE(verified.warnings.size(), std::size_t{1});
    QCOMPARE(verified.warnings.front().check, QStringLiteral("drifts"));
    task.checks.back().scene = task.checks.front().scene;
    warnings = warningsOf(task);
    QCOMPARE(warnings.back().kind, LabFinding::Kind::CheckIsDuplicate);
    QVERIFY2(warnings.back().message.contains(QStringLiteral("the same as drifts")),
             qPrintable(warnings.back().message));
    QVERIFY(verifyLab(labOf(task)).front().findings.empty());
}

void TestLabVerifier::solutionIsJudgedWithEverySeed()
{
    const VerifiedTask verified = verifyLab(labOf(soundTask()), {}, {}, 12).front();
    const auto isSolution = [](const VerifiedProgram &program) {
        return program.role == VerifiedProgram::Role::Solution;
    };
    const auto solution =
        std::find_if(verified.programs.begin(), verified.programs.end(), isSolution);
    QVERIFY(solution != verified.programs.end());
    QCOMPARE(solution->reports.size(), std::size_t{12});
    for (std::size_t i = 0; i < solution->reports.size(); ++i) {
        QCOMPARE(solution->reports[i].seed, static_cast<qint64>(i) + 1);
        QVERIFY(solution->reports[i].passed);
    }
    QVERIFY(describeVerified(verified).contains(QStringLiteral("with 12 seeds")));
}

void TestLabVerifier::progressReachesTheEnd()
{
    int last = 0;
    int total = 0;
    const JudgeHooks hooks{.progress = [&](int done, int all) {
        QVERIFY(done > last && done <= all);
        last = done;
        total = all;
    }};
    QCOMPARE(verifyLab(labOf(soundTask()), {}, hooks).size(), std::size_t{1});
    // Starter, solution with five seeds, two mistakes and the tolerance of one check.
    QCOMPARE(total, 9);
    QCOMPARE(last, total);
}

void TestLabVerifier::cancelEndsIt()
{
    int told = 0;
    const JudgeHooks hooks{.progress = [&](int, int) { ++told; },
                           .cancelled = [&] { return told >= 2; }};
    QVERIFY(verifyLab(labOf(soundTask()), {}, hooks).empty());
    QVERIFY2(told < 9, qPrintable(QString::number(told)));
}

void TestLabVerifier::usedUpToleranceIsMeasured_data()
{
    QTest::addColumn<double>("off"); ///< the solution from what the check asks for, m
    QTest::addColumn<bool>("tight");
    QTest::newRow("exact") << 0.0 << false;
    QTest::newRow("a third") << 0.33e-3 << false;
    QTest::newRow("nearly a half") << 0.49e-3 << false;
    QTest::newRow("more than a half") << 0.51e-3 << true;
    QTest::newRow("nearly all") << 0.99e-3 << true;
    QTest::newRow("too much: it fails anyway") << 1.01e-3 << false;
}

void TestLabVerifier::usedUpToleranceIsMeasured()
{
    QFETCH(double, off);
    QFETCH(bool, tight);
    const Task task = soundTask();
    CheckSpec check = task.checks[0];
    check.kind = QStringLiteral("ends_at");
    check.parameters = {
        {QStringLiteral("positions"), QJsonArray{QJsonValue(QJsonArray{-1.0 + off, 0.0})}},
        {QStringLiteral("tolerance"), 1e-3}};
    const auto found = findTightTolerance(task, check, [] { return false; });
    QCOMPARE(found.has_value(), tight);
    if (found) {
        QCOMPARE(found->allowed, 1e-3);
        QVERIFY2(found->needed >= off - 1e-9 && found->needed < off + 1e-3 / 512,
                 QByteArray::number(found->needed));
        QCOMPARE(found->variant, QStringLiteral("preset"));
    }
}

/// A drift ends in the same place with every timestep.
void TestLabVerifier::theFirstSceneThatNeedsMostIsNamed()
{
    const Task task = soundTask();
    CheckSpec check = task.checks[0];
    check.kind = QStringLiteral("ends_at");
    check.scene.insert(QStringLiteral("timesteps"), QJsonArray{1.0 / 64, 1.0 / 128});
    check.parameters = {
        {QStringLiteral("positions"), QJsonArray{QJsonValue(QJsonArray{-1.0 + 9e-4, 0.0})}},
        {QStringLiteral("tolerance"), 1e-3}};
    const auto found = findTightTolerance(task, check, [] { return false; });
    QVERIFY(found);
    QCOMPARE(found->variant, makeVariants(task.preset, check, 1).front().name);
}

QTEST_GUILESS_MAIN(TestLabVerifier)
#include "test_lab_verifier.moc"
