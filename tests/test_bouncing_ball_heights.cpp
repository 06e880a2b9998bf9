// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab_test.h"

#include "tasks/runs/observation.h"

#include <algorithm>
#include <cmath>

using namespace cradle;

/// How high the ball of the shipped lab rises: as the law says, as the texts say, in every timing.
class TestBouncingBallHeights : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(bouncingBallLab); }
    void everyTimingAndOrderThatIsRightPasses_data();
    void everyTimingAndOrderThatIsRightPasses();
    void exactBouncesFollowTheLaw();
    void heightsAreThoseOfTheText_data();
    void heightsAreThoseOfTheText();
};

namespace {

const QString bounce = QStringLiteral("BALL2");
const QString heights = QStringLiteral("BALL3");

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

void TestBouncingBallHeights::everyTimingAndOrderThatIsRightPasses_data()
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
void TestBouncingBallHeights::everyTimingAndOrderThatIsRightPasses()
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
        QVERIFY2(report.passed, qPrintable(failedChecks(report)));
    }
}

/// h_n = e^(2n) h_0, seen at steps of 1 ms.
void TestBouncingBallHeights::exactBouncesFollowTheLaw()
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

void TestBouncingBallHeights::heightsAreThoseOfTheText_data()
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
void TestBouncingBallHeights::heightsAreThoseOfTheText()
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

QTEST_GUILESS_MAIN(TestBouncingBallHeights)
#include "test_bouncing_ball_heights.moc"
