// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/steps_reading.h"

#include <cmath>

namespace cradle {

namespace {

using flights::shift;
using flights::Steps;

double ratio(double part, double whole)
{
    return whole == 0.0 ? std::nan("") : part / whole;
}

/// What the flights of one circle say.
class Reading
{
public:
    Reading(const FlownSteps &steps, double h, std::size_t circle)
        : m_rest(steps.rest)
        , m_first(steps.first)
        , m_second(steps.second)
        , m_shifted(steps.shifted)
        , m_h(h)
        , m_i(circle)
    {
    }

    [[nodiscard]] Flight read() const
    {
        Flight flight;
        flight.startedWith = m_first.start[m_i].velocity;
        flight.turnedInto = m_first.before[m_i].velocity;
        flight.firstWay = m_first.before[m_i].position - m_first.start[m_i].position;
        flight.isOfStart = isOfStart(m_first) && isOfStart(m_second);
        flight.wayMade = way(m_first);
        flight.restedAt = m_rest.before[m_i].position;
        flight.acceleration = turn(m_rest) / m_h;
        flight.resets = isNear(m_first.before[m_i].velocity, m_rest.before[m_i].velocity)
                        && isNear(m_second.before[m_i].velocity, m_rest.before[m_i].velocity);
        flight.jumps = isNear(m_shifted.after[m_i].position, m_rest.after[m_i].position);
        flight.keepsOwnPlace = flight.jumps && goesOn(m_first) && goesOn(m_second);
        const Vec2 v = m_first.before[m_i].velocity - m_rest.before[m_i].velocity;
        const Vec2 dx = way(m_first) - way(m_rest);
        const Vec2 dv = turn(m_first) - turn(m_rest);
        flight.way = {ratio(dx.x, v.x * m_h), ratio(dx.y, v.y * m_h)};
        flight.growth = {ratio(dv.x, v.x * m_h), ratio(dv.y, v.y * m_h)};
        if (flight.resets)
            flight.way = flight.growth = {};
        readPartResets(flight);
        flight.carried = carried();
        flight.xFollows = followed(&Vec2::x, &Vec2::y);
        flight.yFollows = followed(&Vec2::y, &Vec2::x);
        flight.startedAt = m_first.start[m_i].position;
        flight.putAt = m_first.before[m_i].position;
        const Vec2 v0 = m_rest.before[m_i].velocity;
        flight.drift = way(m_rest) - m_h * Vec2{flight.way.x * v0.x, flight.way.y * v0.y};
        flight.acceleration =
            flight.acceleration - Vec2{flight.growth.x * v0.x, flight.growth.y * v0.y};
        const Vec2 pulled = turn(m_shifted) - turn(m_rest);
        flight.pull = {pulled.x / (shift.x * m_h), pulled.y / (shift.y * m_h)};
        if (std::abs(flight.pull.x) + std::abs(flight.pull.y) < 1e-6)
            flight.pull = {};
        const Motion next = flight.after(m_second.before[m_i], m_h);
        flight.isWayLinear = isClose(next.position, m_second.after[m_i].position);
        flight.isTurnLinear = isClose(next.velocity, m_second.after[m_i].velocity);
        flight.isKnown = !flight.resets && !flight.resetsX && !flight.resetsY && !flight.jumps
                         && std::abs(flight.carried - 1.0) < 1e-6 && flight.pull == Vec2{}
                         && !flight.isOfStart && !isOfNothing(flight.xFollows)
                         && !isOfNothing(flight.yFollows) && flight.isWayLinear
                         && flight.isTurnLinear;
        flight.seen = {seen(m_first), seen(m_second)};
        flight.fromRest = seen(m_rest);
        flight.crossing = crossing();
        const auto isOfNew = [&](const Steps &s) {
            return isClose(way(s), m_h * s.after[m_i].velocity);
        };
        flight.isWayOfNew = isOfNew(m_first) && isOfNew(m_second);
        return flight;
    }

private:
    /// One part of the velocity that comes out the same, however it started.
    void readPartResets(Flight &flight) const
    {
        const auto same = [&](double Vec2::*part) {
            const double rest = m_rest.before[m_i].velocity.*part;
            const auto is = [&](const Steps &s) {
                return std::abs(s.before[m_i].velocity.*part - rest) <= 1e-9;
            };
            return is(m_first) && is(m_second);
        };
        flight.resetsX = !flight.resets && same(&Vec2::x);
        flight.resetsY = !flight.resets && same(&Vec2::y);
        if (flight.resetsX)
            flight.way.x = flight.growth.x = 0.0;
        if (flight.resetsY)
            flight.way.y = flight.growth.y = 0.0;
    }

    /// Whether both steps take it from its start by the way of one, whichever method that is.
    [[nodiscard]] bool isOfStart(const Steps &s) const
    {
        const auto isOneWay = [&](const Circle &after, Vec2 from, Vec2 to) {
            const Vec2 moved = after.position - s.start[m_i].position;
            return length(moved) > 1e-6
                   && (isClose(moved, m_h * from) || isClose(moved, m_h * to)
                       || isClose(moved, 0.5 * m_h * (from + to)));
        };
        return isOneWay(s.before[m_i], s.start[m_i].velocity, s.before[m_i].velocity)
               && isOneWay(s.after[m_i], s.before[m_i].velocity, s.after[m_i].velocity);
    }

    /// Whether the second step goes about as far as by the velocity, not only as far as another one
    /// makes of a place that is set anew.
    [[nodiscard]] bool goesOn(const Steps &s) const
    {
        return goesByVelocity(way(s), s.before[m_i].velocity, m_h);
    }

    /// Of what two starts are apart, the share that is left one step later; 1 where it is not the
    /// same in x and y.
    [[nodiscard]] double carried() const
    {
        const Vec2 apart = m_shifted.before[m_i].position - m_rest.before[m_i].position;
        const Vec2 start = m_shifted.start[m_i].position - m_rest.start[m_i].position;
        const Vec2 share{apart.x / start.x, apart.y / start.y};
        return std::abs(share.x - share.y) < 1e-6 ? share.x : 1.0;
    }

    /// What \p part of the place goes on from in the first step, where \p other is the other one.
    [[nodiscard]] Flight::Follows followed(double Vec2::*part, double Vec2::*other) const
    {
        using Follows = Flight::Follows;
        const Vec2 start = m_shifted.start[m_i].position - m_rest.start[m_i].position;
        const double apart =
            m_shifted.before[m_i].position.*part - m_rest.before[m_i].position.*part;
        if (std::abs(apart - start.*part) <= 1e-8)
            return Follows::Itself;
        if (std::abs(apart - start.*other) <= 1e-8)
            return Follows::Other;
        const double there = m_rest.before[m_i].position.*part;
        const auto stays = [&](const Steps &s) {
            return std::abs(s.before[m_i].position.*part - there) <= 1e-8
                   && std::abs(s.after[m_i].position.*part - there) <= 1e-8;
        };
        return stays(m_rest) && stays(m_first) && stays(m_second) && stays(m_shifted)
                   ? Follows::Nothing
                   : Follows::Unclear;
    }

    static bool isOfNothing(Flight::Follows f)
    {
        return f == Flight::Follows::Nothing || f == Flight::Follows::Other;
    }

    [[nodiscard]] Vec2 way(const Steps &s) const
    {
        return s.after[m_i].position - s.before[m_i].position;
    }
    [[nodiscard]] Vec2 turn(const Steps &s) const
    {
        return s.after[m_i].velocity - s.before[m_i].velocity;
    }
    static bool isNear(Vec2 a, Vec2 b) { return length(a - b) <= 1e-9 * (1.0 + length(b)); }

    static bool isClose(Vec2 a, Vec2 b) { return length(a - b) <= 1e-8; }

    [[nodiscard]] Flight::Step seen(const Steps &s) const
    {
        return {s.before[m_i].velocity, way(s), turn(s)};
    }

    [[nodiscard]] Flight::Crossing crossing() const
    {
        const auto crosses = [&](const Steps &s, bool x, bool y) {
            const Vec2 v = s.before[m_i].velocity - m_rest.before[m_i].velocity;
            return isClose(way(s) - way(m_rest), m_h * Vec2{x ? v.y : v.x, y ? v.x : v.y});
        };
        const auto both = [&](bool x, bool y) {
            return crosses(m_first, x, y) && crosses(m_second, x, y);
        };
        return both(false, true)   ? Flight::Crossing::XMovesY
               : both(true, false) ? Flight::Crossing::YMovesX
               : both(true, true)  ? Flight::Crossing::Exchanged
                                   : Flight::Crossing::None;
    }

    const Steps &m_rest;
    const Steps &m_first;
    const Steps &m_second;
    const Steps &m_shifted;
    double m_h;
    std::size_t m_i;
};

} // namespace

bool goesByVelocity(Vec2 way, Vec2 velocity, double timestep)
{
    constexpr double ofMethod = 0.2;
    const Vec2 expected = timestep * velocity;
    return length(expected) > 1e-6 && length(way - expected) < ofMethod * length(expected);
}

Flight lawOf(const FlownSteps &steps, double h, std::size_t circle)
{
    return Reading(steps, h, circle).read();
}

} // namespace cradle
