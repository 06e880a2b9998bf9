// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/measurements.h"

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
    void dissipatedAtAWall();
    void dissipatedBetweenCircles();
    void dissipatedCountsTheRightCircles();
    void elasticHitDissipatesNothing();
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

void TestMeasurements::dissipatedAtAWall()
{
    const std::array circles{two({0, 0}, {})};
    const Hit hit{.kind = Hit::Kind::Wall,
                  .a = 0,
                  .b = int(Wall::Top), // no circle of that index
                  .beforeA = {3, 4},
                  .afterA = {3, -2}};
    COMPARE_NEAR(dissipated(hit, circles), 16.0 - 4.0, 1e-13);
}

void TestMeasurements::dissipatedBetweenCircles()
{
    // 2 kg at 4 m/s and 6 kg at rest stick together at 1 m/s: ½ μ u² = ½ · 1.5 · 16
    const std::array circles{two({0, 0}, {}), six({2, 0}, {})};
    const Hit hit{.kind = Hit::Kind::Circle,
                  .a = 0,
                  .b = 1,
                  .beforeA = {4, 0},
                  .afterA = {1, 0},
                  .beforeB = {0, 0},
                  .afterB = {1, 0}};
    COMPARE_NEAR(dissipated(hit, circles), 12.0, 1e-13);
}

void TestMeasurements::dissipatedCountsTheRightCircles()
{
    const std::array circles{six({0, 0}, {}), two({0, 0}, {}), six({2, 0}, {})};
    const Hit hit{.kind = Hit::Kind::Circle,
                  .a = 1,
                  .b = 2,
                  .beforeA = {4, 0},
                  .afterA = {1, 0},
                  .beforeB = {0, 0},
                  .afterB = {1, 0}};
    COMPARE_NEAR(dissipated(hit, circles), 12.0, 1e-13);
}

void TestMeasurements::elasticHitDissipatesNothing()
{
    const std::array circles{two({0, 0}, {}), two({2, 0}, {})};
    const Hit hit{.kind = Hit::Kind::Circle,
                  .a = 0,
                  .b = 1,
                  .beforeA = {4, 1},
                  .afterA = {0, 1},
                  .beforeB = {0, -3},
                  .afterB = {4, -3}};
    COMPARE_NEAR(dissipated(hit, circles), 0.0, 1e-13);
}

QTEST_APPLESS_MAIN(TestMeasurements)
#include "test_measurements.moc"
