// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/sleeping_islands.h"
#include "model/world/measurements.h"
#include "tests/heaps.h"

using namespace cradle;
using namespace cradle::scenes;

/// Heaps of many circles fall asleep when they lie still, and wake when they are hit.
class TestHeapSleep : public QObject
{
    Q_OBJECT
private slots:
    void aHeapFallsAsleep();
    void whatShakesInItsPlaceIsStill();
    void aHeapSleepsAfterHalfASecond();
    void aSleepingHeapWakesWhenItIsHit_data();
    void aSleepingHeapWakesWhenItIsHit();
    void aRowOfSlidersNeverSleeps();
};

namespace {

double fastestOf(const Run &run)
{
    double fastest = 0.0;
    for (const Circle &c : run.world.circles)
        fastest = std::max(fastest, length(c.velocity));
    return fastest;
}

} // namespace

void TestHeapSleep::aHeapFallsAsleep()
{
    Run run(rows(150, 15, 0.15, 0.02));
    run.steps(480);
    QCOMPARE(fastestOf(run), 0.0);
    const std::vector<Circle> asleep = run.world.circles;
    run.steps(60);
    QVERIFY(run.world.circles == asleep);
}

/// The errors of a large pile's pushes shake its circles; a slow fall is no such error.
void TestHeapSleep::whatShakesInItsPlaceIsStill()
{
    constexpr double reach = 0.004;
    SleepingIslands islands;
    islands.start(3);
    for (int step = 1; step <= 40; ++step) {
        const double shaken = step % 2 == 0 ? 0.9 * reach : 0.0;
        QCOMPARE(islands.countStill(0, true, {0, shaken}, reach), step);
        // A fifth of the reach in a step: in the sixth step after it began it is out of reach.
        const int creeping = islands.countStill(1, true, {0.2 * reach * step, 0}, 0.99 * reach);
        QCOMPARE(creeping, 1 + (step - 1) % 5);
        // Fast in every tenth step.
        QCOMPARE(islands.countStill(2, step % 10 != 0, {}, reach), step % 10);
    }
}

/// What lies still does so for half a second, thirty steps, before it sleeps; not for a step less.
/// That is: nobody has come farther than at 0.05 g h for so long, nor been faster than ½ g h.
void TestHeapSleep::aHeapSleepsAfterHalfASecond()
{
    Run run(rows(40, 20, 0.15, 0.02));
    const double reach = 0.05 * g * dt * 0.5;
    std::vector<Circle> begun = run.world.circles; // of each circle, where it began to lie
    std::vector<int> steps(begun.size(), 0);       // for which it does
    int least = 0;
    do {
        run.steps(1);
        const bool sleeps = fastestOf(run) == 0.0;
        for (std::size_t i = 0; i < begun.size(); ++i) {
            const bool slow = length(run[i].velocity) <= 0.5 * g * dt;
            if (!slow || steps[i] == 0 || length(run[i].position - begun[i].position) > reach) {
                begun[i] = run[i];
                steps[i] = slow ? 1 : 0;
            } else {
                ++steps[i];
            }
        }
        least = *std::min_element(steps.begin(), steps.end());
        QCOMPARE(sleeps, least >= 30);
    } while (least < 30 && run.world.step < 480);
    QCOMPARE(least, 30);
}

/// Without friction they go on for ever, however fast.
void TestHeapSleep::aRowOfSlidersNeverSleeps()
{
    for (const double speed : {0.25, 1.0}) {
        Preset preset = rows(40, 40, 0.05, 0.05);
        for (PresetCircle &c : preset.circles)
            c.body.velocity = {speed, 0.0};
        Run run(preset);
        run.steps(60);
        run.stepper.advanceBy(run.world, 0.0, run.hits); // a step of no time changes nothing
        run.steps(60);
        for (std::size_t i = 0; i < 20; ++i) { // the others have come to the wall
            QCOMPARE(run[i].velocity.x, speed);
            COMPARE_NEAR(run[i].position.x, preset.circles[i].body.position.x + speed * 2.0, 1e-9);
        }
    }
}

void TestHeapSleep::aSleepingHeapWakesWhenItIsHit_data()
{
    QTest::addColumn<double>("radius"); // m
    QTest::addColumn<double>("from");   // m
    QTest::addColumn<double>("up");     // m/s
    QTest::addColumn<bool>("aside");
    // It sleeps after thirty steps. Let go, the circle falls onto it in the next ones.
    for (const int step : {31, 32, 33, 34, 35, 36, 38, 40}) {
        const double fall = 0.5 * g * (step + 0.5) * dt * (step + 0.5) * dt;
        QTest::addRow("step %d", step)
            << 0.2 << -halfWidth + 2.0 * 0.039 + 0.2 + fall << 0.0 << false;
    }
    // 8,600 times as heavy.
    QTest::addRow("3 m/s, very wide") << 0.8 << 0.0 << 3.0 << false;
    for (const double up : {2.0, 2.5, 3.0, 4.0, 7.0}) {
        QTest::addRow("%g m/s", up) << 0.2 << 0.5 << up << false;
        QTest::addRow("%g m/s aside", up) << 0.2 << 0.5 << up << true;
        QTest::addRow("%g m/s, wide", up) << 0.4 << 0.5 << up << false;
        QTest::addRow("%g m/s aside, wide", up) << 0.4 << 0.5 << up << true;
    }
}

/// A circle thrown up keeps to its parabola while a heap below falls asleep; it wakes the heap when
/// it comes down on it, and not before.
void TestHeapSleep::aSleepingHeapWakesWhenItIsHit()
{
    Preset preset = rows(100, 100, 0.039, 0.001);
    QFETCH(double, radius); // 0.2 m: 135 times as heavy as those that it hits, 0.4 m: 1,080 times
    QFETCH(double, from);
    QFETCH(double, up);
    QFETCH(bool, aside); // gravity, and all else
    preset.circles.push_back(circle({0.1, from}, {0.3, up}, radius));
    const auto turned = [aside](Vec2 v) { return aside ? Vec2{v.y, v.x} : v; };
    for (PresetCircle &c : preset.circles) {
        c.body.position = turned(c.body.position);
        c.body.velocity = turned(c.body.velocity);
    }
    preset.gravity = turned(preset.gravity);
    Run run(preset);
    bool slept = false;
    bool woke = false;
    for (int step = 1; step <= 130 && !woke; ++step) {
        const std::vector<Circle> before = run.world.circles;
        run.steps(1);
        const Circle &ball = run.world.circles.back();
        const double t = step * dt;
        const Vec2 place = turned(ball.position);
        const bool flies = std::abs(turned(ball.velocity).x - 0.3) < 1e-12;
        if (flies) {
            COMPARE_NEAR(place.x, 0.1 + 0.3 * t, 1e-9);
            COMPARE_NEAR(place.y, from + up * t - 0.5 * g * t * t, 1e-9);
        }
        const bool stays = std::equal(before.begin(), before.end() - 1, run.world.circles.begin());
        if (slept)
            QCOMPARE(stays, flies);
        woke = slept && !stays;
        slept = slept || stays;
    }
    QVERIFY(slept && woke);
    // Who woke does not fall through the floor, where in a step it would by 0.07 radii, and is not
    // pressed into it by what is a thousand times as heavy; none of them gains energy.
    const auto energy = [&] {
        return measure(run.world.circles, preset.gravity, halfWidth).total();
    };
    const double whole = mass(preset.circles.back().body) * g * 2.0 * halfWidth;
    double least = energy();
    for (int step = 0; step < 160; ++step) {
        run.steps(1);
        const double overlap = deepestOverlap(run.world.circles);
        QVERIFY2(overlap <= 1e-4, QByteArray::number(overlap).constData());
        const double gain = (energy() - least) / whole;
        QVERIFY2(gain <= 1e-9, QByteArray::number(gain).constData());
        least = std::min(least, energy());
    }
}

QTEST_APPLESS_MAIN(TestHeapSleep)
#include "test_heap_sleep.moc"
