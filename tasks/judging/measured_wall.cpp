// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_wall.h"

#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double kick = 1e-6;     ///< of a velocity, relative: what no rounding makes
constexpr int stepsAfterwards = 6;
constexpr int stepsOfDrop = 70;

double distanceFrom(Wall wall, double halfWidth, Vec2 place)
{
    return halfWidth - dot(outwardNormal(wall), place);
}

/// Shoots circles at walls and looks.
class WallRange
{
public:
    WallRange(const QString *program, const Ground &ground, const MeasuredFlight &flight)
        : m_program(program)
        , m_ground(ground)
        , m_flight(flight)
        , m_gravity(ground.walls.gravity)
        , m_h(ground.timesteps.empty() ? 1.0 / 60.0 : ground.timesteps.front())
    {
    }

    [[nodiscard]] const Flight &flightOf(int circle) const
    {
        return m_flight.at(m_gravity, m_h, circle);
    }

    /// \param place  which of some places and speeds, from 0
    [[nodiscard]] WallHit shoot(int circle, Wall wall, double e, int place, bool corner) const
    {
        WallHit hit{.circle = circle, .wall = wall, .restitution = e};
        const Ground::Range &radii = m_ground.walls.radii;
        hit.radius = radii.isVaried() ? radii.low + 0.75 * (radii.high - radii.low) : radii.low;
        hit.otherRadius = radii.low;
        const double speeds[] = {1.0, 0.83, 0.91};
        const bool falls = length(flightOf(circle).acceleration) > 1.0;
        const double speed = (falls ? 6.1 : 2.9) * speeds[place % 3];
        const double shares[] = {0.29, 0.62, 0.93};
        hit.stage = stageOf(hit, speed, shares[place % 3], corner);
        watch(hit);
        return hit;
    }

    [[nodiscard]] Drop drop(int circle, double e, double height) const
    {
        Drop drop{.circle = circle, .restitution = e};
        Preset preset = m_ground.stage();
        preset.gravity = fall();
        preset.restitution = e;
        preset.timestep = m_h;
        Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
        c.position = {circle % 2 == 0 ? -1.83 : 1.61, -preset.halfWidth + c.radius + height};
        c.velocity = {0.41, 0.0};
        drop.stage = {preset, true};
        const Flight &flight = m_flight.at(preset.gravity, m_h, circle);
        Probe probe(m_program, drop.stage);
        for (int k = 1; k <= stepsOfDrop; ++k) {
            const Circle before = probe.world().circles[static_cast<std::size_t>(circle)];
            if (!probe.step())
                break;
            const Circle &after = probe.circle(circle);
            const double free = flight.after(before, m_h).velocity.y;
            const bool isLow = before.position.y < -preset.halfWidth + 2.0 * before.radius;
            if (isLow && before.velocity.y > 0.0 && free > 0.0
                && after.velocity.y < -kick * (1.0 + free)) {
                ++drop.again;
                drop.step = drop.step == 0 ? k : drop.step;
            }
        }
        const Circle &end = probe.circle(circle);
        drop.depth = -preset.halfWidth + end.radius - end.position.y;
        if (drop.step == 0)
            drop.step = stepsOfDrop;
        return drop;
    }

    /// The strongest downward gravity of the checks; zero if there is none.
    [[nodiscard]] Vec2 fall() const
    {
        Vec2 strongest{};
        for (const Vec2 g : m_ground.gravities)
            strongest = g.x == 0.0 && g.y < strongest.y ? g : strongest;
        return strongest;
    }
    [[nodiscard]] double timestep() const { return m_h; }

private:
    Stage stageOf(const WallHit &hit, double speed, double share, bool corner) const
    {
        Preset preset = m_ground.stage();
        preset.gravity = m_gravity;
        preset.restitution = hit.restitution;
        preset.timestep = m_h;
        const Vec2 n = outwardNormal(hit.wall);
        const Vec2 t = perpendicular(n);
        const double along = corner ? speed : 0.37 * speed;
        // Far enough away for a program that takes the diameter.
        const double room = 2.4 * hit.radius + (0.3 + share) * speed * m_h;
        for (std::size_t i = 0; i < preset.circles.size(); ++i) {
            Circle &c = preset.circles[i].body;
            if (static_cast<int>(i) == hit.circle) {
                c.radius = hit.radius;
                c.position = (preset.halfWidth - room) * n;
                c.position += corner ? (preset.halfWidth - room) * t : -0.7 * t;
                c.velocity = speed * n + along * t;
            } else {
                // The others fly on in the middle; what happens at the wall is not their affair.
                c.radius = hit.otherRadius;
                c.position = (0.4 + 0.9 * static_cast<double>(i)) * t - 0.6 * n;
                c.velocity = {0.31, 0.47};
            }
        }
        return {preset, true};
    }

    void watch(WallHit &hit) const
    {
        Probe probe(m_program, hit.stage);
        const Preset &preset = hit.stage.preset;
        const Vec2 n = outwardNormal(hit.wall);
        const Flight &flight = flightOf(hit.circle);
        const double speed = dot(n, probe.circle(hit.circle).velocity);
        for (int k = 1; k < 200 && probe.runs(); ++k) {
            const std::vector<Circle> before = probe.world().circles;
            const Circle &c = before[static_cast<std::size_t>(hit.circle)];
            const double distance = distanceFrom(hit.wall, preset.halfWidth, c.position);
            if (distance < -1.3 * hit.radius - 2.0 * speed * m_h)
                return; // all of it is outside
            if (dot(n, c.velocity) < 0.0) {
                hit.missed = true; // something else turns it before it is there
                return;
            }
            if (!probe.step())
                return;
            const Motion free = flight.after(c, m_h);
            const Circle &now = probe.circle(hit.circle);
            const bool turned =
                length(now.velocity - free.velocity) > kick * (1.0 + length(free.velocity));
            const bool moved = length(now.position - free.position) > 1e-7;
            if (!turned && !moved)
                continue;
            note(hit, before, now, free, k);
            hit.turned = turned;
            hit.held = !turned;
            hit.disturbs = disturbsOthers(hit, before, probe);
            follow(hit, probe);
            return;
        }
    }

    void note(WallHit &hit, const std::vector<Circle> &before, const Circle &now,
              const Motion &free, int k) const
    {
        const Preset &preset = hit.stage.preset;
        const Vec2 n = outwardNormal(hit.wall);
        const Vec2 t = perpendicular(n);
        const Circle &c = before[static_cast<std::size_t>(hit.circle)];
        hit.step = k;
        hit.before = distanceFrom(hit.wall, preset.halfWidth, c.position);
        hit.reached = distanceFrom(hit.wall, preset.halfWidth, free.position);
        hit.travel = hit.before - hit.reached;
        hit.came = free.velocity;
        hit.left = now.velocity;
        hit.back = -dot(n, now.velocity) / dot(n, free.velocity);
        hit.along = dot(t, now.velocity) / dot(t, free.velocity);
        hit.after = distanceFrom(hit.wall, preset.halfWidth, now.position);
        hit.leap = std::min(length(now.position - c.position),
                            length(now.position - free.position));
        hit.landed = now.position;
    }

    /// What happens in the steps after the answer.
    void follow(WallHit &hit, Probe &probe) const
    {
        const Vec2 n = outwardNormal(hit.wall);
        Circle c = probe.circle(hit.circle);
        for (int k = 0; k < stepsAfterwards; ++k) {
            if (!probe.step())
                return;
            const Circle &now = probe.circle(hit.circle);
            const Motion free = flightOf(hit.circle).after(c, m_h);
            const bool leaves = dot(n, c.velocity) < 0.0 && dot(n, free.velocity) < 0.0;
            if (leaves && dot(n, now.velocity) > 0.0)
                ++hit.again;
            c = now;
        }
        const double distance = distanceFrom(hit.wall, hit.stage.preset.halfWidth, c.position);
        hit.stays = distance < hit.after + 0.5 * hit.travel;
    }

    /// Whether another circle did not fly freely in the step of the answer.
    bool disturbsOthers(const WallHit &hit, const std::vector<Circle> &before,
                        const Probe &probe) const
    {
        for (std::size_t i = 0; i < before.size(); ++i) {
            const int other = static_cast<int>(i);
            const Flight &flight = flightOf(other);
            if (other == hit.circle || !flight.isKnown)
                continue;
            const Motion free = flight.after(before[i], m_h);
            const Circle &now = probe.circle(other);
            if (length(now.position - free.position) > 1e-6
                || length(now.velocity - free.velocity) > 1e-6)
                return true;
        }
        return false;
    }

    const QString *m_program;
    const Ground &m_ground;
    const MeasuredFlight &m_flight;
    Vec2 m_gravity;
    double m_h;
};

/// The one nearest to ½, where e, e² and 1 − e are told apart best but for the last two.
double middleOf(const std::vector<double> &restitutions)
{
    return *std::min_element(restitutions.begin(), restitutions.end(), [](double a, double b) {
        return std::abs(a - 0.6) < std::abs(b - 0.6);
    });
}

} // namespace

bool WallHit::fits(double distance) const
{
    return reached - 1e-9 <= distance && distance <= before + travel + 1e-9;
}

MeasuredWalls::MeasuredWalls(const QString *program, const Ground &ground, const MeasuredFlight &flight)
{
    const WallRange range(program, ground, flight);
    std::vector<double> all = ground.walls.restitutions;
    std::sort(all.begin(), all.end());
    for (const int circle : ground.walls.circles) {
        const Flight &free = range.flightOf(circle);
        if (!free.isKnown || free.way.x < 0.1 || free.way.y < 0.1)
            continue;
        judged.push_back(circle);
        if (length(free.acceleration) > 1.0)
            blur = 0.05;
        for (const Wall wall : allWalls) {
            for (int place = 0; place < 2; ++place)
                hits.push_back(range.shoot(circle, wall, all.back(), place, false));
        }
        std::vector<double> others;
        std::copy_if(all.begin(), all.end(), std::back_inserter(others),
                     [&](double e) { return e != all.back(); });
        for (std::size_t i = 0; !others.empty() && i < 4; ++i)
            hits.push_back(range.shoot(circle, allWalls[i], middleOf(others), 0, false));
        for (const double e : others) {
            if (e != middleOf(others))
                hits.push_back(range.shoot(circle, Wall::Right, e, 1, false));
        }
        // Under gravity the two walls of a corner are hit in different steps.
        if (ground.walls.gravity == Vec2{}) {
            for (const Wall wall : {Wall::Right, Wall::Top, Wall::Left, Wall::Bottom})
                corners.push_back(range.shoot(circle, wall, all.back(), 0, true));
        }
        if (range.fall() == Vec2{} || !flight.at(range.fall(), range.timestep(), circle).isKnown)
            continue;
        for (const double height : {0.0113, 0.0247, 0.0391})
            drops.push_back(range.drop(circle, all.back(), height));
        if (all.size() > 1)
            drops.push_back(range.drop(circle, *std::min_element(all.begin(), all.end()), 0.0247));
    }
}

bool MeasuredWalls::isLike(const MeasuredWalls &other) const
{
    if (hits.size() != other.hits.size() || drops.size() != other.drops.size())
        return false;
    const auto hitAlike = [&](const WallHit &a, const WallHit &b) {
        if (a.missed || b.missed)
            return a.missed == b.missed;
        if (a.turned != b.turned || a.held != b.held || a.disturbs != b.disturbs
            || a.isLeap() != b.isLeap())
            return false;
        if (!a.turned)
            return true;
        return isAlike(a.back, b.back, blur) && isAlike(a.along, b.along, blur)
               && a.stays == b.stays && (a.again > 0) == (b.again > 0)
               && a.reached <= b.before + b.travel && b.reached <= a.before + a.travel;
    };
    const auto dropAlike = [](const Drop &a, const Drop &b) {
        return (a.again > 0) == (b.again > 0) && std::abs(a.depth - b.depth) < 0.02;
    };
    return std::equal(hits.begin(), hits.end(), other.hits.begin(), hitAlike)
           && std::equal(corners.begin(), corners.end(), other.corners.begin(),
                         other.corners.end(), hitAlike)
           && std::equal(drops.begin(), drops.end(), other.drops.begin(), dropAlike);
}

} // namespace cradle
