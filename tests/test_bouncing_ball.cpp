// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab_test.h"

#include "tasks/proof/lab_verifier.h"
#include "tasks/proof/verified_text.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

using namespace cradle;

/// The bouncing ball, the lab that the tutorial builds, judged from outside.
class TestBouncingBall : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(bouncingBallLab); }
    void everyFileOfTheLabIsRead();
    void everyStepHasWhatAStudentNeeds_data();
    void everyStepHasWhatAStudentNeeds();
    void stepHasNoProblems_data() { addSteps(); }
    void stepHasNoProblems();
    void solutionPresetPassesForFiveSeeds_data() { addSteps(); }
    void solutionPresetPassesForFiveSeeds();
    void wrongSceneFailsByTheCheckThatSeesIt_data();
    void wrongSceneFailsByTheCheckThatSeesIt();
    void luaCheckDoesNotGiveTheAnswerAway();
    void checkThatStopsInAnotherLanguageIsTold();
    void picturesOfTheTextsAreThere();
};

namespace {

const QString drop = QStringLiteral("BALL1");
const QString bounce = QStringLiteral("BALL2");
const QString heights = QStringLiteral("BALL3");

const CheckOutcome *outcomeOf(const CheckReport &report, const QString &check)
{
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [&](const CheckOutcome &each) { return each.id == check; });
    return found == report.checks.end() ? nullptr : &*found;
}

} // namespace

void TestBouncingBall::everyFileOfTheLabIsRead()
{
    for (const Error &finding : m_lab.findings)
        qWarning("%s", qPrintable(finding.toString()));
    QVERIFY(m_lab.findings.empty());
    QCOMPARE(m_lab.tasks.size(), std::size_t{3});
    QCOMPARE(m_lab.id, QStringLiteral("bouncing-ball"));
}

void TestBouncingBall::everyStepHasWhatAStudentNeeds_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("German") << QStringLiteral("de");
}

void TestBouncingBall::everyStepHasWhatAStudentNeeds()
{
    QFETCH(QString, language);
    const Lab lab = *readLab(QLatin1String(bouncingBallLab), language);
    QVERIFY(lab.findings.empty());
    const bool german = language == QLatin1String("de");
    QCOMPARE(lab.title != m_lab.title, german);
    for (std::size_t i = 0; i < lab.tasks.size(); ++i) {
        const Task &task = lab.tasks[i];
        const Task &english = m_lab.tasks[i];
        QVERIFY2(task.prediction, qPrintable(task.id));
        QCOMPARE(task.prediction != english.prediction, german);
        QVERIFY2(task.hints.size() >= 3 && task.codeHints.size() >= 3, qPrintable(task.id));
        QVERIFY2(task.mistakes.size() >= 3, qPrintable(task.id));
        QVERIFY2(task.checks.size() >= 3, qPrintable(task.id));
        QVERIFY2(task.instructions.startsWith(QStringLiteral("# ") + task.title),
                 qPrintable(task.id));
        QCOMPARE(task.title != english.title, german);
        QCOMPARE(task.hints != english.hints, german);
        QCOMPARE(task.codeHints != english.codeHints, german);
        for (std::size_t c = 0; c < task.checks.size(); ++c)
            QCOMPARE(task.checks[c].title != english.checks[c].title, german);
        for (std::size_t m = 0; m < task.mistakes.size(); ++m)
            QCOMPARE(task.mistakes[m].message != english.mistakes[m].message, german);
        for (std::size_t r = 0; r < task.remarks.size(); ++r)
            QCOMPARE(task.remarks[r].script.message != english.remarks[r].script.message, german);
    }
}

void TestBouncingBall::stepHasNoProblems()
{
    QFETCH(QString, step);
    const std::vector<VerifiedTask> tasks = verifyLab(m_lab, step);
    QCOMPARE(tasks.size(), std::size_t{1});
    QVERIFY2(tasks.front().findings.empty(), qPrintable(describeVerified(tasks.front())));
}

void TestBouncingBall::solutionPresetPassesForFiveSeeds()
{
    QFETCH(QString, step);
    QVERIFY(!judgeTask(m_lab, task(step), task(step).preset, 1)->passed);
    for (qint64 seed = 1; seed <= 5; ++seed) {
        const CheckReport report = *judgeTask(m_lab, task(step), solution(step), seed);
        QVERIFY2(report.passed, qPrintable(failedChecks(report)));
    }
}

void TestBouncingBall::wrongSceneFailsByTheCheckThatSeesIt_data()
{
    using Change = void (*)(Preset &);
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("check");
    QTest::addColumn<Change>("change");
    const auto row = [](const char *name, const QString &step, const char *check, Change change) {
        QTest::newRow(name) << step << QString::fromLatin1(check) << change;
    };
    row("thrown", drop, "start", [](Preset &p) { p.circles[0].body.velocity = {0.0, 2.0}; });
    row("upward", drop, "falls", [](Preset &p) { p.gravity = {0.0, 9.81}; });
    row("Euler", drop, "moon", [](Preset &p) { p.circles[0].integrator = Integrator::Euler; });
    row("Moon", bounce, "falls", [](Preset &p) { p.gravity = {0.0, -1.62}; });
    row("elastic", bounce, "bounces", [](Preset &p) { p.restitution = 1.0; });
    row("no walls", bounce, "any-restitution", [](Preset &p) { p.laws.walls = WallLaw::None; });
    row("sinks", bounce, "stays-inside", [](Preset &p) { p.laws.walls = WallLaw::None; });
    row("from elsewhere", heights, "start", [](Preset &p) {
        p.circles[0].body.position = {0.0, 0.0};
    });
    row("speed halved", heights, "half", [](Preset &p) { p.restitution = std::cbrt(0.5); });
    row("e for the height", heights, "half", [](Preset &p) { p.restitution = 0.5; });
    row("too lively", heights, "half", [](Preset &p) { p.restitution = 0.93; });
    row("weaker gravity", heights, "falls", [](Preset &p) { p.gravity = {0.0, -5.0}; });
    row("no walls", heights, "floor", [](Preset &p) { p.laws.walls = WallLaw::None; });
    row("no floor", heights, "law", [](Preset &p) { p.laws.walls = WallLaw::None; });
}

void TestBouncingBall::wrongSceneFailsByTheCheckThatSeesIt()
{
    using Change = void (*)(Preset &);
    QFETCH(QString, step);
    QFETCH(QString, check);
    QFETCH(Change, change);
    Preset preset = solution(step);
    change(preset);
    QVERIFY(!findFault(preset));
    const CheckReport report = *judgeTask(m_lab, task(step), preset, 1);
    const CheckOutcome *outcome = outcomeOf(report, check);
    QVERIFY(outcome);
    QVERIFY2(!outcome->passed, qPrintable(failedChecks(report)));
    QVERIFY(!outcome->message.isEmpty());
}

/// Finding e is the student's part.
void TestBouncingBall::luaCheckDoesNotGiveTheAnswerAway()
{
    const CheckReport report = *judgeTask(m_lab, task(heights), task(heights).preset, 1);
    const CheckOutcome *outcome = outcomeOf(report, QStringLiteral("half"));
    QVERIFY(outcome && !outcome->passed);
    QVERIFY2(!outcome->message.contains(QStringLiteral("0.89")), qPrintable(outcome->message));
    QVERIFY2(outcome->message.contains(QStringLiteral("1.35 m")), qPrintable(outcome->message));
    QCOMPARE(outcome->expected.value_or(0.0), 2.5);
    QCOMPARE(outcome->unit, QStringLiteral("m"));
    const Lab german = *readLab(QLatin1String(bouncingBallLab), QStringLiteral("de"));
    const Task &step = german.tasks[static_cast<std::size_t>(german.indexOf(heights))];
    const CheckReport germanReport = *judgeTask(german, step, step.preset, 1);
    QCOMPARE(outcomeOf(germanReport, QStringLiteral("half"))->message,
             QStringLiteral("Nach Aufprall 3 steigt der Ball auf 1.35 m; die Hälfte von 5.00 m "
                            "sind 2.50 m"));
}

/// A check may answer in the student's language, and stop in that one alone.
void TestBouncingBall::checkThatStopsInAnotherLanguageIsTold()
{
    LabFiles files = *m_lab.files;
    files.contents.insert(QStringLiteral("BALL3/checks/half-height.lua"),
                          "function check(run)\n"
                          "  if run.language == 'de' then error('halt') end\n"
                          "  return true\n"
                          "end\n");
    const Result<Lab> lab = readLab(files, m_lab.folder, QStringLiteral("en"));
    QVERIFY(lab);
    const std::vector<VerifiedTask> tasks = verifyLab(*lab, heights, {}, 1);
    int told = 0;
    for (const LabFinding &finding : tasks.front().findings) {
        if (!finding.message.startsWith(QLatin1String("in the language ")))
            continue;
        ++told;
        QVERIFY2(finding.message.startsWith(QLatin1String("in the language de: "))
                     && finding.message.contains(QLatin1String("halt")),
                 qPrintable(finding.message));
        QCOMPARE(finding.check, QStringLiteral("half"));
    }
    QVERIFY(told > 0);
}

void TestBouncingBall::picturesOfTheTextsAreThere()
{
    static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]+\\]\\(([^)]+)\\)"));
    int pictures = 0;
    for (const char *language : {"en", "de"}) {
        const Lab lab = *readLab(QLatin1String(bouncingBallLab), QLatin1String(language));
        for (const Task &task : lab.tasks) {
            auto found = picture.globalMatch(task.instructions);
            while (found.hasNext()) {
                const QString file = found.next().captured(1);
                QVERIFY2(QFile::exists(task.folder + QLatin1Char('/') + file), qPrintable(file));
                ++pictures;
            }
        }
    }
    QCOMPARE(pictures, 4);
}

QTEST_GUILESS_MAIN(TestBouncingBall)
#include "test_bouncing_ball.moc"
