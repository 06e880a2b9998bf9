// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/preset_json.h"
#include "tasks/checker.h"
#include "tasks/lab_reader.h"
#include "tasks/lab_verifier.h"
#include "tasks/observation.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using namespace cradle;

/// The bouncing ball, the lab that the tutorial builds, judged from outside.
class TestBouncingBall : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void everyFileOfTheLabIsRead();
    void everyStepHasWhatAStudentNeeds_data();
    void everyStepHasWhatAStudentNeeds();
    void stepHasNoProblems_data() { addSteps(); }
    void stepHasNoProblems();
    void solutionPresetPassesForFiveSeeds_data() { addSteps(); }
    void solutionPresetPassesForFiveSeeds();
    void wrongSceneFailsByTheCheckThatSeesIt_data();
    void wrongSceneFailsByTheCheckThatSeesIt();
    void everyTimingAndOrderThatIsRightPasses_data();
    void everyTimingAndOrderThatIsRightPasses();
    void exactBouncesFollowTheLaw();
    void heightsAreThoseOfTheText_data();
    void heightsAreThoseOfTheText();
    void luaCheckDoesNotGiveTheAnswerAway();
    void picturesOfTheTextsAreThere();

private:
    void addSteps();
    [[nodiscard]] const Task &task(const QString &id) const;
    [[nodiscard]] Preset solution(const QString &id) const;

    Lab m_lab;
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

QString faultsOf(const CheckReport &report)
{
    QStringList lines;
    for (const CheckOutcome &check : report.checks) {
        if (!check.passed)
            lines.append(check.id + QStringLiteral(": ") + check.message);
    }
    return lines.join(QLatin1Char('\n'));
}

/// How high the rim comes above the floor after each bounce of the first \p seconds, m.
std::vector<double> heightsAfterBounces(const Preset &preset, double seconds)
{
    const Observation run = observe({QStringLiteral("run"), preset, seconds, false});
    std::vector<double> tops;
    double top = 0.0;
    bool fell = false;
    for (qint64 k = 1; k <= run.steps(); ++k) {
        const Circle &ball = run.circle(0, k);
        const bool falls = ball.velocity.y < 0.0;
        if (fell && !falls) {
            tops.push_back(top);
            top = 0.0;
        }
        top = std::max(top, ball.position.y - ball.radius + preset.halfWidth);
        fell = falls;
    }
    tops.erase(tops.begin());
    return tops;
}

} // namespace

void TestBouncingBall::initTestCase()
{
    const Result<Lab> lab = readLab(QLatin1String(bouncingBallLab));
    QVERIFY2(lab.ok(), lab ? "" : qPrintable(lab.error().toString()));
    m_lab = *lab;
}

void TestBouncingBall::addSteps()
{
    QTest::addColumn<QString>("step");
    for (const Task &task : m_lab.tasks)
        QTest::newRow(qPrintable(task.id)) << task.id;
}

const Task &TestBouncingBall::task(const QString &id) const
{
    return m_lab.tasks[static_cast<std::size_t>(m_lab.indexOf(id))];
}

Preset TestBouncingBall::solution(const QString &id) const
{
    return *readPreset(task(id).folder + QStringLiteral("/solution-preset.json"));
}

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
        QVERIFY2(report.passed, qPrintable(faultsOf(report)));
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
    QVERIFY2(!outcome->passed, qPrintable(faultsOf(report)));
    QVERIFY(!outcome->message.isEmpty());
}

void TestBouncingBall::everyTimingAndOrderThatIsRightPasses_data()
{
    QTest::addColumn<Timing>("timing");
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("timestep");
    constexpr double usual = 1.0 / 60.0;
    QTest::newRow("fine") << Timing::Discrete << Integrator::SymplecticEuler << usual / 2.0;
    QTest::newRow("coarse") << Timing::Discrete << Integrator::SymplecticEuler << 2.0 * usual;
    QTest::newRow("Verlet") << Timing::Discrete << Integrator::Verlet << usual;
    QTest::newRow("continuous") << Timing::Continuous << Integrator::SymplecticEuler << usual;
    QTest::newRow("both") << Timing::Continuous << Integrator::Verlet << usual;
    QTest::newRow("exact") << Timing::Exact << Integrator::SymplecticEuler << usual;
}

/// The last step invites to try other timings: whoever then presses Check must not fail by it.
void TestBouncingBall::everyTimingAndOrderThatIsRightPasses()
{
    Preset preset = solution(heights);
    QFETCH(Timing, timing);
    QFETCH(Integrator, integrator);
    QFETCH(double, timestep);
    preset.laws.timing = timing;
    preset.circles[0].integrator = integrator;
    preset.timestep = timestep;
    for (qint64 seed = 1; seed <= 5; ++seed) {
        const CheckReport report = *judgeTask(m_lab, task(heights), preset, seed);
        QVERIFY2(report.passed, qPrintable(faultsOf(report)));
    }
}

/// h_n = e^(2n) h_0, seen at steps of 1 ms.
void TestBouncingBall::exactBouncesFollowTheLaw()
{
    Preset preset = solution(bounce);
    preset.laws.timing = Timing::Exact;
    preset.timestep = 1e-3;
    const std::vector<double> tops = heightsAfterBounces(preset, 7.0);
    QVERIFY(tops.size() >= 4);
    double expected = 5.0;
    for (std::size_t n = 0; n < 4; ++n) {
        expected *= 0.8 * 0.8;
        QVERIFY2(std::abs(tops[n] - expected) < 2e-6, QByteArray::number(tops[n], 'g', 10));
    }
}

void TestBouncingBall::heightsAreThoseOfTheText_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<Timing>("timing");
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("third");
    QTest::newRow("e = 0.8") << bounce << Timing::Discrete << Integrator::SymplecticEuler
                             << QStringLiteral("3.192") << QStringLiteral("1.351");
    QTest::newRow("half") << heights << Timing::Discrete << Integrator::SymplecticEuler
                          << QStringLiteral("3.96") << QStringLiteral("2.52");
    QTest::newRow("continuous") << heights << Timing::Continuous << Integrator::SymplecticEuler
                                << QString() << QStringLiteral("2.22");
    QTest::newRow("Verlet") << heights << Timing::Continuous << Integrator::Verlet << QString()
                            << QStringLiteral("2.50");
}

/// What the text of the last step says of heights is what the engine does, in both languages.
void TestBouncingBall::heightsAreThoseOfTheText()
{
    QFETCH(QString, step);
    QFETCH(Timing, timing);
    QFETCH(Integrator, integrator);
    QFETCH(QString, first);
    QFETCH(QString, third);
    Preset preset = solution(step);
    preset.laws.timing = timing;
    preset.circles[0].integrator = integrator;
    const std::vector<double> tops = heightsAfterBounces(preset, 8.0);
    const auto digits = [](const QString &number) {
        return static_cast<int>(number.size() - number.indexOf(QLatin1Char('.')) - 1);
    };
    if (!first.isEmpty())
        QCOMPARE(QString::number(tops[0], 'f', digits(first)), first);
    // 2.215 m is half-way between two of the text's figures.
    QVERIFY2(std::abs(tops[2] - third.toDouble()) <= 0.0055, QByteArray::number(tops[2]));
    const Lab german = *readLab(QLatin1String(bouncingBallLab), QStringLiteral("de"));
    for (const Lab &lab : {m_lab, german}) {
        const QString &text =
            lab.tasks[static_cast<std::size_t>(lab.indexOf(heights))].instructions;
        QVERIFY(text.contains(first));
        QVERIFY(text.contains(third));
    }
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
