// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"
#include "tests/generators.h"

#include <numeric>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr Laws exact{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};

/// m/s; in an inelastic collapse (a heavy circle drives a light one into a wall, e small) the
/// speeds fall geometrically. Hits faster than this must follow the law even then.
constexpr double slowest = 1e-3;

/// Σ m |v|, the size that an error of the momentum is measured by.
double sizeOfMomentum(const std::vector<Circle> &circles)
{
    return std::accumulate(circles.begin(), circles.end(), 0.0, [](double sum, const Circle &c) {
        return sum + mass(c) * length(c.velocity);
    });
}

} // namespace

/// What mechanics says of every run in exact timing, whatever solves it.
class TestExactLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { useFixedCases(); }
    void onlyGravityChangesTheMomentum();
    void elasticRunsKeepTheirEnergy();
    void hitsScaleTheRelativeNormalSpeed();
    void hitsComeInOrderOfTime();
    void aChangedWorldIsTakenUp();
};

void TestExactLaws::onlyGravityChangesTheMomentum()
{
    QVERIFY(rc::check("P = P_0 + M g t, any e", [] {
        Preset preset = someCircles({WallLaw::None, CircleLaw::Impulse, Timing::Exact});
        for (PresetCircle &c : preset.circles)
            c.body.velocity -= 2.0 * c.body.position; // most of them meet
        preset.restitution = numberIn(0.0, 1.0);
        preset.gravity = anyGravity();
        Run run(preset);
        const Vec2 before = measure(run.world.circles, {}, halfWidth).momentum;
        double total = 0.0;
        for (const Circle &c : run.world.circles)
            total += mass(c);
        run.steps(120);
        const Vec2 after = measure(run.world.circles, {}, halfWidth).momentum;
        RC_ASSERT(close(after, before + total * run.world.time * preset.gravity,
                        1e-12 * (sizeOfMomentum(run.world.circles) + length(before))));
    }));
}

void TestExactLaws::elasticRunsKeepTheirEnergy()
{
    QVERIFY(rc::check("walls, with and without gravity", [] {
        Preset preset = someCircles(exact);
        preset.gravity = anyGravity();
        Run run(preset);
        const double before = measure(run.world.circles, preset.gravity, halfWidth).total();
        // Potential energies far from 0 cancel: the error is measured by their sizes.
        double size = measure(run.world.circles, {}, halfWidth).kinetic;
        for (const Circle &c : run.world.circles)
            size += mass(c) * length(preset.gravity) * 2.0 * halfWidth;
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            const double now = measure(run.world.circles, preset.gravity, halfWidth).total();
            RC_ASSERT(close(now, before, 1e-12 * size));
        }
    }));
}

void TestExactLaws::hitsScaleTheRelativeNormalSpeed()
{
    QVERIFY(rc::check("u' = -e u at pairs and walls, nothing across", [] {
        Preset preset = someCircles(exact);
        const double e = preset.restitution = numberIn(0.0, 1.0);
        Run run(preset);
        run.steps(120);
        for (std::size_t i = 0; i < run.hits.size(); ++i) {
            const Hit &hit = run.hits[i];
            // Of hits at one moment each tells the velocities before and after them all.
            const bool alone = (i == 0 || run.hits[i - 1].time < hit.time)
                               && (i + 1 == run.hits.size() || hit.time < run.hits[i + 1].time);
            if (!alone)
                continue;
            const double closing = dot(hit.beforeA - hit.beforeB, hit.normal);
            RC_ASSERT(closing > 0.0);
            const double parting = dot(hit.afterB - hit.afterA, hit.normal);
            // Where hits come faster and faster without end, slow ones may end as rest or lose
            // nothing. No other.
            RC_ASSERT(close(parting, e * closing, 1e-13 * 50.0)
                      || (closing < slowest
                          && (close(parting, 0.0, 1e-13 * 50.0)
                              || close(parting, closing, 1e-13 * 50.0))));
            RC_ASSERT(close(cross(hit.afterA - hit.beforeA, hit.normal), 0.0, 1e-13 * 50.0));
            RC_ASSERT(close(cross(hit.afterB - hit.beforeB, hit.normal), 0.0, 1e-13 * 50.0));
            RC_ASSERT(close(length(hit.normal), 1.0, 1e-15));
            const Circle &a = run[static_cast<std::size_t>(hit.a)];
            RC_ASSERT(close(dot(hit.beforeA - hit.afterA, hit.normal) * mass(a), hit.impulse,
                            1e-12 * mass(a) * 50.0));
        }
    }));
}

void TestExactLaws::hitsComeInOrderOfTime()
{
    QVERIFY(rc::check("each inside the step that it is told in", [] {
        Preset preset = someCircles(exact);
        preset.gravity = anyGravity();
        preset.restitution = numberIn(0.5, 1.0);
        Run run(preset);
        double latest = 0.0;
        for (int step = 1; step <= 120; ++step) {
            const std::size_t before = run.hits.size();
            run.steps(1);
            RC_ASSERT(run.world.step == step);
            for (std::size_t i = before; i < run.hits.size(); ++i) {
                const Hit &hit = run.hits[i];
                RC_ASSERT(hit.step == step);
                RC_ASSERT(hit.time >= latest && hit.time <= run.world.time + 1e-15);
                RC_ASSERT(hit.time >= (step - 1) * dt - 1e-15);
                latest = hit.time;
            }
        }
    }));
}

void TestExactLaws::aChangedWorldIsTakenUp()
{
    // Whoever steps may change the circles between two steps: what was foreseen is void then.
    QVERIFY(rc::check("as a fresh stepper goes on from there, bit for bit", [] {
        Preset preset = someCircles(exact);
        preset.gravity = anyGravity();
        preset.restitution = *rc::gen::element(1.0, 0.9);
        Run run(preset);
        run.steps(*rc::gen::inRange(1, 60));
        const std::size_t one = *rc::gen::inRange<std::size_t>(0, run.world.circles.size());
        switch (*rc::gen::inRange(0, 3)) {
        case 0:
            for (Circle &c : run.world.circles)
                c.velocity = -c.velocity;
            break;
        case 1:
            run.world.circles[one].velocity = vectorIn(5.0);
            break;
        default:
            run.world.circles[one].density *= 4.0;
        }
        Run fresh(preset);
        fresh.world = run.world;
        run.hits.clear();
        run.steps(60);
        fresh.steps(60);
        RC_ASSERT(run.world == fresh.world);
        RC_ASSERT(run.hits == fresh.hits);
    }));
}

QTEST_GUILESS_MAIN(TestExactLaws)
#include "test_exact_laws.moc"
