// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model/world/measurements.h"
#include "tests/generators.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// More hits than a few circles have in 5 s, unless they hand the same push to and fro.
constexpr std::size_t manyHits = 2000;

/// A few circles on a lattice in the lab's square, none in touch, all moving.
Preset fewCircles(Laws laws)
{
    Preset preset = scene({}, laws);
    const int count = *rc::gen::inRange(1, 9);
    for (int i = 0; i < count; ++i) {
        const Vec2 site{-2.0 + 2.0 * (i % 3), -2.0 + 2.0 * (i / 3)};
        preset.circles.push_back(circle(site + vectorIn(0.4), vectorIn(5.0), numberIn(0.1, 0.5),
                                        anyIntegrator(), numberIn(0.5, 10.0)));
    }
    return preset;
}

/// Σ m |v|, the size that an error of the momentum is measured by.
double sizeOfMomentum(const World &world)
{
    double sum = 0.0;
    for (const Circle &c : world.circles)
        sum += mass(c) * length(c.velocity);
    return sum;
}

} // namespace

/// Laws that any run of a few circles obeys.
class TestRunLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void continuousRunsKeepMomentumAndEnergy();
    void continuousRunsNeitherOverlapNorLeave();
    void continuousRunsGainNoEnergy();
    void continuousRunsGoBackTheWayTheyCame();
    void discreteRunsStayInside();
    void aMovingObserverSeesTheSameHits();
};

void TestRunLaws::initTestCase()
{
    useFixedCases();
}

void TestRunLaws::continuousRunsKeepMomentumAndEnergy()
{
    QVERIFY(rc::check("no walls, e = 1, 2 s", [] {
        Run run(fewCircles({WallLaw::None, CircleLaw::Impulse, Timing::Continuous}));
        const Totals before = measure(run.world.circles, {}, halfWidth);
        const double size = sizeOfMomentum(run.world);
        run.steps(120);
        const Totals after = measure(run.world.circles, {}, halfWidth);
        RC_ASSERT(close(after.momentum, before.momentum, 1e-12 * size));
        RC_ASSERT(close(after.kinetic, before.kinetic, 1e-12 * before.kinetic));
    }));
}

void TestRunLaws::continuousRunsNeitherOverlapNorLeave()
{
    QVERIFY(rc::check("walls, no gravity, any e, 5 s", [] {
        Preset preset = fewCircles({WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        preset.restitution = numberIn(0.0, 1.0);
        Run run(preset);
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            RC_ASSERT(run.hits.size() < manyHits);
            const auto &circles = run.world.circles;
            for (std::size_t i = 0; i < circles.size(); ++i) {
                const Circle &c = circles[i];
                const double room = halfWidth - c.radius + 1e-9;
                RC_ASSERT(std::abs(c.position.x) <= room && std::abs(c.position.y) <= room);
                for (std::size_t j = i + 1; j < circles.size(); ++j) {
                    const double sum = c.radius + circles[j].radius;
                    RC_ASSERT(length(circles[j].position - c.position) >= sum - 1e-9);
                }
            }
        }
    }));
}

void TestRunLaws::continuousRunsGainNoEnergy()
{
    QVERIFY(rc::check("walls, no gravity, any e: the loss is that of the hits", [] {
        Preset preset = fewCircles({WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        preset.restitution = numberIn(0.0, 1.0);
        Run run(preset);
        const double before = measure(run.world.circles, {}, halfWidth).kinetic;
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            RC_ASSERT(run.hits.size() < manyHits);
        }
        // Of hits at the same moment each reports the velocities before and after them all.
        for (std::size_t i = 1; i < run.hits.size(); ++i)
            RC_PRE(run.hits[i].time > run.hits[i - 1].time);
        double lost = 0.0;
        for (const Hit &hit : run.hits) {
            const double taken = hit.loss;
            RC_ASSERT(taken >= -1e-12 * before);
            lost += taken;
        }
        const double after = measure(run.world.circles, {}, halfWidth).kinetic;
        RC_ASSERT(close(before - after, lost, 1e-10 * before));
    }));
}

void TestRunLaws::continuousRunsGoBackTheWayTheyCame()
{
    QVERIFY(rc::check("two circles, walls, e = 1: 2 s forth and back", [] {
        Preset preset = scene({circle(Vec2{-2, 0} + vectorIn(1.0), vectorIn(3.0), 0.3),
                               circle(Vec2{2, 0} + vectorIn(1.0), vectorIn(3.0), 0.4)},
                              {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        Run run(preset);
        const World start = run.world;
        run.steps(120);
        for (Circle &c : run.world.circles)
            c.velocity = -c.velocity;
        run.steps(120);
        for (std::size_t i = 0; i < 2; ++i) {
            RC_ASSERT(close(run[i].position, start.circles[i].position, 1e-7));
            RC_ASSERT(close(-run[i].velocity, start.circles[i].velocity, 1e-7));
        }
    }));
}

void TestRunLaws::discreteRunsStayInside()
{
    QVERIFY(rc::check("within one step's travel", [] {
        Preset preset = fewCircles({WallLaw::Reflect, CircleLaw::None, Timing::Discrete});
        preset.gravity = {0, -g};
        preset.restitution = numberIn(0.0, 0.9);
        Run run(preset);
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            for (const Circle &c : run.world.circles) {
                const double travel = length(c.velocity) * dt + g * dt * dt;
                const double room = halfWidth - c.radius + travel;
                RC_ASSERT(std::abs(c.position.x) <= room && std::abs(c.position.y) <= room);
            }
        }
    }));
}

void TestRunLaws::aMovingObserverSeesTheSameHits()
{
    QVERIFY(rc::check("Galilei", [] {
        Preset preset = scene({circle(Vec2{-1, 0} + vectorIn(0.4), vectorIn(3.0), 0.3),
                               circle(Vec2{1, 0} + vectorIn(0.4), vectorIn(3.0), 0.4)},
                              {WallLaw::None, CircleLaw::Impulse, Timing::Continuous});
        preset.restitution = numberIn(0.1, 1.0);
        Preset moving = preset;
        const Vec2 drift = vectorIn(3.0);
        for (PresetCircle &c : moving.circles)
            c.body.velocity += drift;
        Run here(preset);
        Run there(moving);
        here.steps(60);
        there.steps(60);
        // A hit that grazes may be missed by the one and not by the other, but changes little.
        for (std::size_t i = 0; i < 2; ++i) {
            RC_ASSERT(close(there[i].velocity, here[i].velocity + drift, 1e-6));
            RC_ASSERT(close(there[i].position, here[i].position + drift, 1e-6));
        }
    }));
}

QTEST_GUILESS_MAIN(TestRunLaws)
#include "test_run_laws.moc"
