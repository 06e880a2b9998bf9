// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_paths.h"

#include "tasks/judging/likeness.h"
#include "tasks/judging/probe.h"

#include <algorithm>

namespace cradle {

namespace {

/// Of v h, of one of two circles that go unequally far: a longer way begins behind walls.
constexpr double longestWay = 3.0;

} // namespace

PairPaths::PairPaths(const QString *program, const Ground &ground, const MeasuredFlight &flight)
    : m_program(program)
    , m_ground(ground)
    , m_flight(flight)
    , m_h(ground.stage().timestep)
{
}

double PairPaths::slowness(double h) const
{
    return areEven() ? 1.0 / m_flight.at({}, h)[0].way.x : 1.0;
}

bool PairPaths::areEven() const
{
    const auto &flights = m_flight.at({}, m_h);
    return isAlike(flights[0].way.x, flights[1].way.x) && flights[0].leader < 0
           && flights[1].leader < 0;
}

bool PairPaths::areKnown() const
{
    for (const double h : {m_h, shortStep}) {
        const auto &flights = m_flight.at({}, h);
        for (std::size_t i = 0; i < 2; ++i) {
            const Flight &f = flights[i];
            if (f.leader >= 0 && !areEven() && followsLaw(i, h))
                continue;
            if (!f.isKnown || f.way.x <= 0.0 || !isAlike(f.way.x, f.way.y)
                || length(f.drift) > 0.1 * f.way.x * h * slowness(h)
                || (!areEven() && (f.way.x > longestWay || !followsLaw(i, h))))
                return false;
        }
    }
    return fliesAlike();
}

bool PairPaths::followsLaw(std::size_t i, double h) const
{
    Preset preset = m_ground.stage();
    preset.timestep = h;
    preset.circles[0].body.position = {-1.7, 0.9};
    preset.circles[0].body.velocity = {0.6, 0.2};
    preset.circles[1].body.position = {1.8, -0.1};
    preset.circles[1].body.velocity = {0.3, -0.5};
    Probe probe(m_program, {preset, true});
    const std::vector<Circle> before = probe.world().circles;
    if (!probe.step())
        return false;
    const Circle &now = probe.circle(static_cast<int>(i));
    return length(now.velocity - before[i].velocity) < 1e-9
           && length(now.position - before[i].position - wayOf(i, before, h)) < 1e-9;
}

Vec2 PairPaths::wayOf(std::size_t i, const std::vector<Circle> &circles, double h) const
{
    const Flight &f = m_flight.at({}, h)[i];
    return f.leader >= 0 ? h * circles[static_cast<std::size_t>(f.leader)].velocity
                         : f.after(circles[i], h).position - circles[i].position;
}

Motion PairPaths::free(std::size_t i, const std::vector<Circle> &circles, double h,
                       Vec2 gravity) const
{
    const Circle &c = circles[i];
    return areEven() ? m_flight.at(gravity, h)[i].after(c, h)
                     : Motion{c.position + h * c.velocity, c.velocity};
}

std::vector<Circle> PairPaths::aimed(const std::vector<Circle> &circles, double h) const
{
    std::vector<Circle> set = circles;
    for (std::size_t i = 0; i < 2 && !areEven(); ++i)
        set[i].position = free(i, circles, h).position - wayOf(i, circles, h);
    return set;
}

bool PairPaths::fliesAlike() const
{
    const Ground::Pair &asked = m_ground.pair;
    if (!asked.radii.isVaried() && !asked.densities.isVaried() && asked.restitutions.size() < 2)
        return true;
    Preset preset = m_ground.stage();
    preset.restitution = *std::min_element(asked.restitutions.begin(), asked.restitutions.end());
    const double speed = slowness(m_h);
    preset.circles[0].body = {
        {-1.7, 0.9}, {0.6 * speed, 0.2 * speed}, asked.radii.low, asked.densities.high};
    preset.circles[1].body = {
        {1.8, -0.1}, {0.3 * speed, -0.5 * speed}, asked.radii.high, asked.densities.low};
    Probe probe(m_program, {preset, true});
    const std::vector<Circle> before = probe.world().circles;
    // What stops the program is told as that.
    if (!probe.step())
        return true;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 alone = free(i, before, m_h).velocity;
        if (length(probe.circle(static_cast<int>(i)).velocity - alone) > 1e-4 * speed)
            return false;
    }
    return true;
}

} // namespace cradle
