// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/sleeping_islands.h"
#include "tests/scenes.h"

#include <algorithm>
#include <array>

using namespace cradle;

/// Who sleeps with whom, and for how long who has been at rest.
class TestSleepingIslands : public QObject
{
    Q_OBJECT
private slots:
    void stepsAtRestAreCountedInARow();
    void theCountEndsAt255();
    void anIslandWakesAsOne();
    void whoWokeBeginsToCountAnew();
    void islandsAreNumberedAnewWhenNoneSleeps();
    void aStartWakesAll();
    void whoFallsOnASleeperIsNeverLate();
};

void TestSleepingIslands::stepsAtRestAreCountedInARow()
{
    SleepingIslands islands;
    islands.start(2);
    QCOMPARE(islands.countStill(1, true, {}, 0.0), 1);
    QCOMPARE(islands.countStill(1, true, {}, 0.0), 2);
    QCOMPARE(islands.countStill(0, true, {}, 0.0), 1); // each for itself
    QCOMPARE(islands.countStill(1, false, {}, 0.0), 0);
    QCOMPARE(islands.countStill(1, true, {}, 0.0), 1);
}

void TestSleepingIslands::theCountEndsAt255()
{
    SleepingIslands islands;
    islands.start(1);
    for (int step = 1; step <= 255; ++step)
        QCOMPARE(islands.countStill(0, true, {}, 0.0), step);
    QCOMPARE(islands.countStill(0, true, {}, 0.0), 255);
    QCOMPARE(islands.countStill(0, true, {}, 0.0), 255);
}

void TestSleepingIslands::anIslandWakesAsOne()
{
    SleepingIslands islands;
    islands.start(6);
    QCOMPARE(islands.count(), std::size_t{0});
    islands.lay(std::array{1U, 4U});
    islands.lay(std::array{0U, 2U, 5U});
    QCOMPARE(islands.count(), std::size_t{5});
    QVERIFY(!islands.sleeps(3));

    std::vector<std::uint32_t> woken = islands.wake(4);
    std::sort(woken.begin(), woken.end());
    QVERIFY((woken == std::vector{1U, 4U}));
    QCOMPARE(islands.count(), std::size_t{3});
    for (const std::uint32_t circle : {1U, 3U, 4U})
        QVERIFY(!islands.sleeps(circle));
    for (const std::uint32_t circle : {0U, 2U, 5U})
        QVERIFY(islands.sleeps(circle));
}

void TestSleepingIslands::whoWokeBeginsToCountAnew()
{
    SleepingIslands islands;
    islands.start(2);
    for (int step = 0; step < 30; ++step)
        (void)islands.countStill(0, true, {}, 0.0);
    islands.lay(std::array{0U});
    islands.wake(0);
    QCOMPARE(islands.countStill(0, true, {}, 0.0), 1);
}

void TestSleepingIslands::islandsAreNumberedAnewWhenNoneSleeps()
{
    SleepingIslands islands;
    islands.start(3);
    islands.lay(std::array{0U, 1U});
    islands.wake(1);
    QCOMPARE(islands.count(), std::size_t{0});
    islands.lay(std::array{2U});
    QVERIFY(islands.sleeps(2));
    QVERIFY(!islands.sleeps(0));
    QVERIFY((islands.wake(2) == std::vector{2U}));
}

void TestSleepingIslands::aStartWakesAll()
{
    SleepingIslands islands;
    islands.start(2);
    (void)islands.countStill(1, true, {}, 0.0);
    islands.lay(std::array{0U});
    islands.start(3);
    QCOMPARE(islands.count(), std::size_t{0});
    islands.lay(std::array{2U});
    QVERIFY(!islands.sleeps(0));
    QCOMPARE(islands.countStill(1, true, {}, 0.0), 1);
}

/// From sixty heights, the lowest after the row on the floor has gone to sleep, which does not fall
/// with those above: however long ago it was seen who may meet whom.
void TestSleepingIslands::whoFallsOnASleeperIsNeverLate()
{
    constexpr std::size_t columns = 60;
    constexpr double radius = 0.05;
    Preset preset = scenes::scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -scenes::g};
    preset.restitution = 0.5;
    for (std::size_t i = 0; i < 2 * columns; ++i) {
        const auto column = static_cast<double>(i % columns);
        const double height = i < columns ? 0.0 : 1.6 + 0.1 * column;
        preset.circles.push_back(scenes::circle(
            {-3.9 + 0.13 * column, -scenes::halfWidth + radius + height}, {}, radius));
    }
    scenes::Run run(preset);
    for (int step = 0; step < 90; ++step) {
        run.steps(1);
        for (std::size_t i = 0; i < columns; ++i) {
            const double gap = run[columns + i].position.y - run[i].position.y - 2.0 * radius;
            QVERIFY2(gap >= -1e-4 * radius, QByteArray::number(gap).constData());
        }
    }
    QVERIFY(run.hits.size() >= columns);
}

QTEST_APPLESS_MAIN(TestSleepingIslands)
#include "test_sleeping_islands.moc"
