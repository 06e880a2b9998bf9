// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/one_step.h"

#include "model/run/stepper.h"
#include "tasks/checks/motion.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

/// Relative; ten times what the checks allow, since two programs may round in another order.
constexpr double same = 1e-8;
/// The same where a normal had to be searched for.
constexpr double sameFound = 1e-6;
/// How far from a hit two programs may tell it, in steps of the pair's own motion.
constexpr double earliest = -1.0;
constexpr double latest = 1.0;
constexpr int looks = 9;        ///< of the search for a normal, evenly spread
constexpr int refinements = 40; ///< each makes the interval 0.62 times as long

bool isNear(Vec2 a, Vec2 b, double tolerance)
{
    return length(a - b) <= tolerance * (1.0 + length(b));
}

/// Sum of the differences of velocity, m/s.
double difference(const std::vector<Circle> &made, std::span<const Circle> wanted)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < made.size(); ++i)
        sum += length(made[i].velocity - wanted[i].velocity);
    return sum;
}

} // namespace

OneStep::OneStep(const QString &program, const Variant &scene, std::optional<double> restitution)
    : m_program(program, {.pinned = scene.pinned, .quiet = true, .locked = {}})
{
    Preset start = scene.preset;
    m_runs = !m_program.begin(start) && m_program.moves();
    if (m_runs && restitution)
        m_program.setRestitution(*restitution);
}

std::optional<OneStep::Circles> OneStep::update(const World &world, double dt)
{
    World next = world;
    if (m_program.advance(next, dt))
        return std::nullopt;
    return next.circles;
}

bool OneStep::agrees(const Observation &o, qint64 k, Places places)
{
    const auto made = update(o.states.world(k), o.timestep());
    if (!made)
        return false;
    if (places != Places::Only && isFarFrom(o, k, *made))
        return false;
    bool all = true;
    for (std::size_t i = 0; i < made->size() && all; ++i)
        all = agreesFreely(o, k, *made, i, places);
    return all || (places != Places::Only && agreesAtSomeNormal(o, k));
}

/// Whether one of the two puts a circle where no way of handling a hit brings it.
bool OneStep::isFarFrom(const Observation &o, qint64 k, const Circles &made) const
{
    const Vec2 gravity = o.variant.preset.gravity;
    double way = 0.0;
    for (int i = 0; i < o.circleCount(); ++i)
        way += motion::recentTravel(o, i, k, gravity);
    for (std::size_t i = 0; i < made.size(); ++i) {
        const Vec2 after = o.circle(static_cast<int>(i), k + 1).position;
        if (length(made[i].position - after) > motion::longestLeap * way)
            return true;
    }
    return false;
}

/// One circle. Where it was hit, how far it comes in that step depends on how the hit is handled.
bool OneStep::agreesFreely(const Observation &o, qint64 k, const Circles &made, std::size_t i,
                           Places places) const
{
    const Circle &before = o.circle(static_cast<int>(i), k);
    const Circle &after = o.circle(static_cast<int>(i), k + 1);
    const double dt = o.timestep();
    const Vec2 turned = after.velocity - before.velocity;
    if (places != Places::Only) {
        if (!isNear(made[i].velocity, after.velocity, same))
            return false;
        if (motion::isKicked(o, static_cast<int>(i), k, o.variant.preset.gravity)
            && length(turned) > same * (1.0 + length(before.velocity)))
            return true;
    }
    const double slack = places == Places::Exact ? 0.0 : 1.01 * length(turned) * dt;
    return length(made[i].position - after.position)
           <= same * (1.0 + length(after.position)) + slack;
}

/// With discrete steps two programs may take the normal of a contact at different moments of the
/// same step, or one late. So the pair is moved along its own way until the known program gives
/// the student's velocities, if it ever does.
bool OneStep::agreesAtSomeNormal(const Observation &o, qint64 k)
{
    if (o.circleCount() != 2)
        return false;
    const Vec2 gravity = o.variant.preset.gravity;
    // Who only does not fall has not been hit.
    const auto isHit = [&](int i) {
        const Vec2 before = o.circle(i, k).velocity;
        return motion::isKicked(o, i, k, gravity)
               && length(o.circle(i, k + 1).velocity - before) > same * (1.0 + length(before));
    };
    if (!isHit(0) && !isHit(1))
        return false;
    const double dt = o.timestep();
    const World world = o.states.world(k);
    const double gap = length(world.circles[1].position - world.circles[0].position)
                       - world.circles[0].radius - world.circles[1].radius;
    const double reach = motion::travel(o, 0, k, gravity) + motion::travel(o, 1, k, gravity);
    if (gap > reach)
        return false;
    const std::span<const Circle> wanted = o.states.circles(k + 1);
    const auto differenceAt = [&](double steps) {
        World shifted = world;
        for (Circle &circle : shifted.circles)
            circle.position += steps * dt * circle.velocity;
        const auto made = update(shifted, dt);
        return made ? difference(*made, wanted) : 1e300;
    };
    double best = 1e300;
    double at = 0.0;
    const double width = (latest - earliest) / (looks - 1);
    for (int i = 0; i < looks; ++i) {
        const double s = earliest + i * width;
        if (const double d = differenceAt(s); d < best) {
            best = d;
            at = s;
        }
    }
    const double speed = length(world.circles[0].velocity) + length(world.circles[1].velocity);
    // A normal turns little in so short a time; what is far off is another law.
    if (best > 0.5 * speed)
        return false;
    // Golden section search, Kiefer 1953: of its two looks one is that of the interval before.
    constexpr double ratio = 0.6180339887498949;
    double low = std::max(earliest, at - width);
    double high = std::min(latest, at + width);
    double left = high - ratio * (high - low);
    double right = low + ratio * (high - low);
    double dLeft = differenceAt(left);
    double dRight = differenceAt(right);
    best = std::min({best, dLeft, dRight});
    for (int i = 1; i < refinements && best > sameFound * (1.0 + speed); ++i) {
        if (dLeft < dRight) {
            high = std::exchange(right, left);
            left = high - ratio * (high - low);
            dRight = std::exchange(dLeft, differenceAt(left));
            best = std::min(best, dLeft);
        } else {
            low = std::exchange(left, right);
            right = low + ratio * (high - low);
            dLeft = std::exchange(dRight, differenceAt(right));
            best = std::min(best, dRight);
        }
    }
    return best <= sameFound * (1.0 + speed);
}

} // namespace cradle
