// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generators.h"

#include <numeric>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr Laws exact{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};

/// By how much a difference at the start may have grown after \p hits. At a hit of two circles by
/// up to 1 + 2 l/(R cos φ): l ≤ 11 m the flight before the next hit, R the sum of the radii, φ the
/// angle of the relative velocity with the normal.
double growthOf(const std::vector<Hit> &hits, const World &world)
{
    double growth = 1.0;
    for (const Hit &hit : hits) {
        if (hit.kind == Hit::Kind::Wall)
            continue;
        const double distance = world.circles[static_cast<std::size_t>(hit.a)].radius
                                + world.circles[static_cast<std::size_t>(hit.b)].radius;
        const Vec2 relative = hit.beforeA - hit.beforeB;
        growth *= 1.0 + 22.0 * length(relative) / (distance * dot(relative, hit.normal));
    }
    return growth;
}

/// What remains of a difference of some roundings; runs where it would be no measure are left out.
double allowedAfter(const Run &run)
{
    const double allowed = 1e-13 * growthOf(run.hits, run.world);
    RC_PRE(allowed < 1e-6);
    return allowed;
}

/// Every vector of \p preset through \p turn.
template <class Turn>
Preset turned(Preset preset, Turn turn)
{
    preset.gravity = turn(preset.gravity);
    for (PresetCircle &c : preset.circles) {
        c.body.position = turn(c.body.position);
        c.body.velocity = turn(c.body.velocity);
    }
    return preset;
}

} // namespace

/// What may be changed of a scene in exact timing without a change of what happens in it.
class TestExactSymmetries : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { useFixedCases(); }
    void turnsAndMirrorsAreExactToTheBit();
    void orderOfCirclesDoesNotMatter();
    void runsGoBackTheWayTheyCame();
    void unitsDoNotMatter();
    void aMovingObserverSeesTheSame();
};

void TestExactSymmetries::turnsAndMirrorsAreExactToTheBit()
{
    // A quarter turn and a mirror make all eight ways in which a square lies on itself.
    QVERIFY(rc::check("the square's symmetries", [] {
        Preset preset = someCircles(exact);
        preset.gravity = anyGravity();
        preset.restitution = *rc::gen::element(1.0, 0.9);
        const auto quarter = [](Vec2 v) { return perpendicular(v); };
        const auto mirror = [](Vec2 v) { return Vec2{-v.x, v.y}; };
        Run here(preset);
        Run turn(turned(preset, quarter));
        Run mirrored(turned(preset, mirror));
        for (int step = 0; step < 120; ++step) {
            here.steps(1);
            turn.steps(1);
            mirrored.steps(1);
            for (std::size_t i = 0; i < preset.circles.size(); ++i) {
                RC_ASSERT(turn[i].position == quarter(here[i].position));
                RC_ASSERT(turn[i].velocity == quarter(here[i].velocity));
                RC_ASSERT(mirrored[i].position == mirror(here[i].position));
                RC_ASSERT(mirrored[i].velocity == mirror(here[i].velocity));
            }
        }
        RC_ASSERT(turn.hits.size() == here.hits.size());
        RC_ASSERT(mirrored.hits.size() == here.hits.size());
    }));
}

void TestExactSymmetries::orderOfCirclesDoesNotMatter()
{
    QVERIFY(rc::check("bit for bit", [] {
        Preset preset = someCircles(exact);
        preset.gravity = anyGravity();
        preset.restitution = *rc::gen::element(1.0, 0.9);
        std::vector<std::size_t> order(preset.circles.size());
        std::iota(order.begin(), order.end(), 0U);
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[*rc::gen::inRange<std::size_t>(0, i)]);
        Preset shuffled = preset;
        for (std::size_t i = 0; i < order.size(); ++i)
            shuffled.circles[i] = preset.circles[order[i]];
        Run here(preset);
        Run there(shuffled);
        here.steps(120);
        there.steps(120);
        RC_ASSERT(there.hits.size() == here.hits.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            RC_ASSERT(there[i] == here[order[i]]);
    }));
}

void TestExactSymmetries::runsGoBackTheWayTheyCame()
{
    QVERIFY(rc::check("e = 1: half a second forth and back", [] {
        Preset preset = someCircles(exact, 2, 4);
        preset.gravity = anyGravity();
        Run run(preset);
        const World start = run.world;
        run.steps(30);
        const std::size_t hits = run.hits.size();
        for (Circle &c : run.world.circles)
            c.velocity = -c.velocity;
        run.steps(30);
        const double allowed = allowedAfter(run);
        RC_ASSERT(run.hits.size() == 2 * hits);
        for (std::size_t i = 0; i < start.circles.size(); ++i) {
            RC_ASSERT(close(run[i].position, start.circles[i].position, allowed));
            RC_ASSERT(close(-run[i].velocity, start.circles[i].velocity, 10.0 * allowed));
        }
    }));
}

void TestExactSymmetries::unitsDoNotMatter()
{
    QVERIFY(rc::check("lengths and times by powers of two", [] {
        Preset preset = someCircles(exact);
        preset.gravity = anyGravity();
        preset.restitution = *rc::gen::element(1.0, 0.9);
        const double metre = std::ldexp(1.0, *rc::gen::inRange(-12, 9));
        const double second = std::ldexp(1.0, *rc::gen::inRange(-8, 3));
        Preset other = preset;
        other.halfWidth *= metre;
        other.gravity = (metre / (second * second)) * other.gravity;
        other.timestep *= second;
        for (PresetCircle &c : other.circles) {
            c.body.position = metre * c.body.position;
            c.body.velocity = (metre / second) * c.body.velocity;
            c.body.radius *= metre;
        }
        Run here(preset);
        Run there(other);
        here.steps(60);
        there.steps(60);
        const double allowed = allowedAfter(here);
        RC_ASSERT(there.hits.size() == here.hits.size());
        for (std::size_t i = 0; i < preset.circles.size(); ++i) {
            RC_ASSERT(close(there[i].position / metre, here[i].position, allowed));
            RC_ASSERT(
                close(there[i].velocity * (second / metre), here[i].velocity, 10.0 * allowed));
        }
    }));
}

void TestExactSymmetries::aMovingObserverSeesTheSame()
{
    QVERIFY(rc::check("Galilei, no walls, any e", [] {
        Preset preset = someCircles({WallLaw::None, CircleLaw::Impulse, Timing::Exact}, 2, 5);
        preset.gravity = anyGravity();
        preset.restitution = numberIn(0.1, 1.0);
        const Vec2 drift = vectorIn(3.0);
        const Preset moving = [&] {
            Preset p = preset;
            for (PresetCircle &c : p.circles)
                c.body.velocity += drift;
            return p;
        }();
        Run here(preset);
        Run there(moving);
        here.steps(60);
        there.steps(60);
        const double allowed = allowedAfter(here);
        for (std::size_t i = 0; i < preset.circles.size(); ++i) {
            RC_ASSERT(close(there[i].velocity, here[i].velocity + drift, 10.0 * allowed));
            RC_ASSERT(
                close(there[i].position, here[i].position + here.world.time * drift, allowed));
        }
    }));
}

QTEST_GUILESS_MAIN(TestExactSymmetries)
#include "test_exact_symmetries.moc"
