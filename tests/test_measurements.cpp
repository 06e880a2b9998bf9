// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"

#include "tests/scenes.h"

#include <array>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// A circle of 2 kg, and one of 6 kg.
Circle two(Vec2 position, Vec2 velocity)
{
    return {position, velocity, 1.0, 2.0 / (4000.0 / 3.0 * pi)};
}

Circle six(Vec2 position, Vec2 velocity)
{
    return {position, velocity, 1.0, 6.0 / (4000.0 / 3.0 * pi)};
}

} // namespace

class TestMeasurements : public QObject
{
    Q_OBJECT
private slots:
    void ofOneCircleByHand();
    void potentialEnergyIsZeroAtTheFloor();
    void potentialEnergyCountsBothPartsOfGravity();
    void allTogetherAreTheSum();
    void ofNoCirclesIsNothing();
    void centreOfMassByHand();
    void deviationByHand();
    void deviationOfTheSameIsNone();
    void hitsSayWhatTheyTook_data();
    void hitsSayWhatTheyTook();
    void aCornerIsNotCountedTwice_data();
    void aCornerIsNotCountedTwice();
};

void TestMeasurements::ofOneCircleByHand()
{
    const Totals totals = measure(two({1, 3}, {3, -4}), {0, -10}, 4.0);
    COMPARE_NEAR(totals.momentum.x, 6.0, 1e-14);
    COMPARE_NEAR(totals.momentum.y, -8.0, 1e-14);
    COMPARE_NEAR(totals.kinetic, 25.0, 1e-13);
    COMPARE_NEAR(totals.potential, 140.0, 1e-12); // 2 kg · 10 m/s² · 7 m
    COMPARE_NEAR(totals.total(), 165.0, 1e-12);
}

void TestMeasurements::potentialEnergyIsZeroAtTheFloor()
{
    COMPARE_NEAR(measure(two({2, -4}, {}), {0, -g}, 4.0).potential, 0.0, 1e-15);
}

void TestMeasurements::potentialEnergyCountsBothPartsOfGravity()
{
    // −m g·(x, y + 4) = −2 (3·1 + (−4)·(5))
    COMPARE_NEAR(measure(two({1, 1}, {}), {3, -4}, 4.0).potential, 34.0, 1e-12);
}

void TestMeasurements::allTogetherAreTheSum()
{
    const std::array circles{two({0, 0}, {1, 0}), six({0, 1}, {-1, 2})};
    const Totals totals = measure(circles, {0, -10}, 4.0);
    COMPARE_NEAR(totals.momentum.x, -4.0, 1e-13);
    COMPARE_NEAR(totals.momentum.y, 12.0, 1e-13);
    COMPARE_NEAR(totals.kinetic, 1.0 + 15.0, 1e-13);
    COMPARE_NEAR(totals.potential, 80.0 + 300.0, 1e-12);
}

void TestMeasurements::ofNoCirclesIsNothing()
{
    QVERIFY(measure(std::span<const Circle>(), {0, -g}, 4.0) == Totals{});
}

void TestMeasurements::centreOfMassByHand()
{
    const std::array circles{two({4, 0}, {}), six({0, -8}, {})};
    const Vec2 centre = centreOfMass(circles); // (2 · 4, 6 · −8) / 8
    COMPARE_NEAR(centre.x, 1.0, 1e-14);
    COMPARE_NEAR(centre.y, -6.0, 1e-14);
    QCOMPARE(centreOfMass({}), Vec2{});
}

void TestMeasurements::deviationByHand()
{
    const std::array run{two({3, 4}, {2, 0}), six({0, 1}, {0, 1})};
    const std::array exact{two({0, 0}, {0, 1}), six({0, 0}, {0, 1})};
    const Deviation off = deviation(run, exact, {0, -10}, 4.0);
    COMPARE_NEAR(off.greatest, 5.0, 1e-14);
    COMPARE_NEAR(off.rootMeanSquare, std::sqrt((25.0 + 1.0) / 2.0), 1e-14);
    // Kinetic 4 − 1 J, potential 2 kg · 10 m/s² · 4 m and 6 kg · 10 m/s² · 1 m.
    COMPARE_NEAR(off.energy, 3.0 + 80.0 + 60.0, 1e-11);
    COMPARE_NEAR(greatestDistance(run, exact), 5.0, 1e-14);
    // Of those that both have.
    QCOMPARE(greatestDistance(std::span(run).last(1), exact), 1.0);
    QCOMPARE(greatestDistance(exact, std::span(run).last(1)), 1.0);
    QCOMPARE(greatestDistance(run, {}), 0.0);
}

void TestMeasurements::deviationOfTheSameIsNone()
{
    const std::array circles{two({3, 4}, {2, 0}), six({0, 1}, {0, 1})};
    QVERIFY(deviation(circles, circles, {0, -10}, 4.0) == Deviation{});
    QVERIFY(deviation({}, {}, {0, -10}, 4.0) == Deviation{});
}

void TestMeasurements::hitsSayWhatTheyTook_data()
{
    QTest::addColumn<int>("law");
    QTest::addColumn<int>("timing");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("loss"); // J; 2 kg at 4 m/s against 6 kg at rest, ½ m v² = 16 J
    for (const Timing timing : {Timing::Discrete, Timing::Continuous, Timing::Exact}) {
        const QByteArray name = shortName(timing);
        const auto row = [&](const char *what, CircleLaw law, double e, double loss) {
            QTest::newRow(name + ' ' + what) << int(law) << int(timing) << e << loss;
        };
        row("elastic", CircleLaw::Impulse, 1.0, 0.0);
        row("half", CircleLaw::Impulse, 0.5, 9.0); // (1 − e²) ½ μ u², μ = 1.5 kg
        row("plastic", CircleLaw::Impulse, 0.0, 12.0);
        row("stop", CircleLaw::Stop, 1.0, 16.0);
        row("swap", CircleLaw::SwapVelocities, 1.0, 16.0 - 48.0); // 6 kg at 4 m/s: more than before
    }
}

void TestMeasurements::hitsSayWhatTheyTook()
{
    QFETCH(int, law);
    QFETCH(int, timing);
    QFETCH(double, restitution);
    QFETCH(double, loss);
    Preset preset;
    preset.restitution = restitution;
    preset.laws = {WallLaw::None, static_cast<CircleLaw>(law), static_cast<Timing>(timing)};
    preset.circles = {PresetCircle{.name = {}, .body = two({0, 0}, {4, 0})},
                      PresetCircle{.name = {}, .body = six({3, 0}, {0, 0})}};
    Run run(preset);
    run.steps(60);
    QCOMPARE(run.hits.size(), std::size_t{1});
    COMPARE_NEAR(run.hits.front().loss, loss, 1e-9);
}

void TestMeasurements::aCornerIsNotCountedTwice_data()
{
    QTest::addColumn<int>("timing");
    QTest::newRow("discrete") << int(Timing::Discrete);
    QTest::newRow("continuous") << int(Timing::Continuous);
}

void TestMeasurements::aCornerIsNotCountedTwice()
{
    // Both walls at once, e = ½: each takes ¾ of the energy of its own part, 2 · ¾ · ½ m 4².
    QFETCH(int, timing);
    Preset preset = scene({circle({3.5, 3.5}, {4, 4})},
                          {WallLaw::Reflect, CircleLaw::None, static_cast<Timing>(timing)});
    preset.restitution = 0.5;
    Run run(preset);
    run.steps(30);
    double lost = 0.0;
    for (const Hit &hit : run.hits)
        lost += hit.loss;
    COMPARE_NEAR(lost, 12.0 * 261.380508778670797, 1e-9);
}

QTEST_APPLESS_MAIN(TestMeasurements)
#include "test_measurements.moc"
