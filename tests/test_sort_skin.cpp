// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/sort_skin.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

/// For how many steps a sort is good, by hand: as long as no circle has come farther than the skin.
class TestSortSkin : public QObject
{
    Q_OBJECT
private slots:
    void lastsUntilTheFastestHasCrossedIt_data();
    void lastsUntilTheFastestHasCrossedIt();
    void isAsWideAsAStepOfTheFastest();
    void whatRestsNeverCrossesIt();
    void kicksAddUp();
    void theGainOfGravityIsForeseen();
};

void TestSortSkin::lastsUntilTheFastestHasCrossedIt_data()
{
    QTest::addColumn<double>("gravity"); // m/s²
    QTest::addColumn<double>("speed");   // m/s
    QTest::newRow("straight") << 0.0 << 2.1;
    QTest::newRow("straight and slow") << 0.0 << 1.01;
    QTest::newRow("falling from rest") << g << 0.0;
    QTest::newRow("falling") << g << 3.0;
    QTest::newRow("gently falling") << 0.3 << 1.5;
}

void TestSortSkin::lastsUntilTheFastestHasCrossedIt()
{
    QFETCH(double, gravity);
    QFETCH(double, speed);
    constexpr double width = 1.0; // m
    SortSkin skin;
    skin.start(dt, gravity, width, speed);
    // An integrator may be a step's gain ahead: s (v + g Δt) + ½ g s².
    const auto way = [&](double steps) {
        const double s = steps * dt;
        return s * (speed + gravity * dt) + 0.5 * gravity * s * s;
    };
    const auto steps = static_cast<double>(skin.steps());
    QVERIFY(steps > 1 && steps < static_cast<double>(SortSkin::mostSteps));
    QVERIFY(way(steps) <= width);
    QVERIFY(way(steps + 1.0) > width);
    QCOMPARE(skin.fastest(), speed);
    COMPARE_NEAR(skin.travel(3.0 * dt, speed), way(3.0), 1e-15);
    COMPARE_NEAR(skin.driftAfter(3), way(3.0), 1e-15);
    QCOMPARE(skin.driftAfter(60), width);
}

void TestSortSkin::isAsWideAsAStepOfTheFastest()
{
    SortSkin skin;
    skin.start(dt, 0.0, 0.1, 60.0);
    COMPARE_NEAR(skin.width(), 1.0, 1e-15);
    QCOMPARE(skin.steps(), 1U);
    skin.start(dt, 0.0, 0.1, 1.0);
    QCOMPARE(skin.width(), 0.1);
}

void TestSortSkin::whatRestsNeverCrossesIt()
{
    SortSkin skin;
    skin.start(dt, 0.0, 0.1, 0.0);
    QCOMPARE(skin.steps(), SortSkin::mostSteps);
    QCOMPARE(skin.driftAfter(64), 0.0);
}

/// Ten steps at 2.1 m/s, the last of which may have been flown at 4 m/s already, leave
/// 1 − 10 · 0.035 − 0.0667 = 0.5833 m, or 8.75 steps.
void TestSortSkin::kicksAddUp()
{
    SortSkin skin;
    skin.start(dt, 0.0, 1.0, 2.1);
    QCOMPARE(skin.steps(), 28U);
    skin.note(2.1, 5);
    QCOMPARE(skin.steps(), 28U);
    skin.note(4.0, 10);
    QCOMPARE(skin.steps(), 18U);
    QCOMPARE(skin.fastest(), 4.0);
    COMPARE_NEAR(skin.driftAfter(10), 25.0 / 60.0, 1e-15);
    COMPARE_NEAR(skin.driftAfter(12), 33.0 / 60.0, 1e-15);
    // Two steps later another: 1 − 33/60 − 5/60 = 22/60 m, or 4.4 steps.
    skin.note(5.0, 12);
    COMPARE_NEAR(skin.driftAfter(12), 38.0 / 60.0, 1e-15);
    QCOMPARE(skin.steps(), 16U);
    // What is slower than was noted shortens nothing.
    skin.note(3.0, 14);
    COMPARE_NEAR(skin.driftAfter(14), 48.0 / 60.0, 1e-15);
    QCOMPARE(skin.steps(), 16U);
}

/// 1 m/s and six steps of g make 1.981 m/s.
void TestSortSkin::theGainOfGravityIsForeseen()
{
    SortSkin skin;
    skin.start(dt, g, 1.0, 1.0);
    const std::size_t steps = skin.steps();
    const double drift = skin.driftAfter(8);
    skin.note(1.98, 6);
    QCOMPARE(skin.fastest(), 1.0);
    QCOMPARE(skin.steps(), steps);
    QCOMPARE(skin.driftAfter(8), drift);
    skin.note(1.99, 6);
    QCOMPARE(skin.fastest(), 1.99);
    QVERIFY(skin.driftAfter(8) > drift);
}

QTEST_APPLESS_MAIN(TestSortSkin)
#include "test_sort_skin.moc"
