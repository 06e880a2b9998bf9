// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_reading.h"

#include "tasks/judging/flight_scenes.h"
#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

using namespace flights;

double ratio(double part, double whole)
{
    return whole == 0.0 ? std::nan("") : part / whole;
}

/// What the flights of one circle say.
class Reading
{
public:
    Reading(const Steps &rest, const Steps &first, const Steps &second, const Steps &shifted,
            double h, std::size_t circle)
        : m_rest(rest)
        , m_first(first)
        , m_second(second)
        , m_shifted(shifted)
        , m_h(h)
        , m_i(circle)
    {
    }

    [[nodiscard]] Flight read() const
    {
        Flight flight;
        flight.startedWith = m_first.start[m_i].velocity;
        flight.turnedInto = m_first.before[m_i].velocity;
        flight.wayMade = way(m_first);
        flight.acceleration = turn(m_rest) / m_h;
        flight.resets = isNear(m_first.before[m_i].velocity, m_rest.before[m_i].velocity)
                        && isNear(m_second.before[m_i].velocity, m_rest.before[m_i].velocity);
        flight.jumps = isNear(m_shifted.after[m_i].position, m_rest.after[m_i].position);
        const Vec2 v = m_first.before[m_i].velocity - m_rest.before[m_i].velocity;
        const Vec2 dx = way(m_first) - way(m_rest);
        const Vec2 dv = turn(m_first) - turn(m_rest);
        flight.way = {ratio(dx.x, v.x * m_h), ratio(dx.y, v.y * m_h)};
        flight.growth = {ratio(dv.x, v.x * m_h), ratio(dv.y, v.y * m_h)};
        if (flight.resets)
            flight.way = flight.growth = {};
        readPartResets(flight);
        flight.carried = carried();
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
                         && flight.isWayLinear && flight.isTurnLinear;
        flight.seen = {seen(m_first), seen(m_second)};
        flight.crossing = crossing();
        flight.isWayOfNew = isClose(way(m_first), m_h * m_first.after[m_i].velocity)
                            && isClose(way(m_second), m_h * m_second.after[m_i].velocity);
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

    /// Of what two starts are apart, the share that is left one step later; 1 where it is not the
    /// same in x and y.
    [[nodiscard]] double carried() const
    {
        const Vec2 apart = m_shifted.before[m_i].position - m_rest.before[m_i].position;
        const Vec2 start = m_shifted.start[m_i].position - m_rest.start[m_i].position;
        const Vec2 share{apart.x / start.x, apart.y / start.y};
        return std::abs(share.x - share.y) < 1e-6 ? share.x : 1.0;
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

/// The circle whose velocity moves circle \p i, where its own does not.
int leaderOf(const QString *program, const Ground &ground, Vec2 gravity, double h, std::size_t i,
             const Steps &rest)
{
    for (std::size_t j = 0; j < ground.flights.size(); ++j) {
        if (j == i)
            continue;
        const Steps alone = fly(program, flightPreset(ground, gravity, h, Scene::Alone, j));
        if (!alone.made)
            continue;
        const Vec2 moved = alone.after[i].position - alone.before[i].position
                           - (rest.after[i].position - rest.before[i].position);
        const Vec2 v = alone.before[j].velocity - rest.before[j].velocity;
        if (length(moved - h * v) <= 1e-9 + 1e-6 * length(moved) && length(v) > 0.0)
            return static_cast<int>(j);
    }
    return -1;
}

/// The circle whose velocity circle \p i has one step later, but for what it has from rest.
int borrowedBy(const Steps &rest, const Steps &first, const Steps &second, std::size_t i)
{
    const auto isFrom = [&](const Steps &s, std::size_t j) {
        const Vec2 got = s.before[i].velocity - rest.before[i].velocity;
        return length(got - s.start[j].velocity) < 1e-9;
    };
    for (std::size_t j = 0; j < rest.start.size(); ++j) {
        if (j != i && isFrom(first, j) && isFrom(second, j))
            return static_cast<int>(j);
    }
    return -1;
}

/// The circle at whose place circle \p i is after the first step, though it started elsewhere.
int followedBy(const Steps &steps, std::size_t i)
{
    const auto isAt = [](const Circle &a, const Circle &b) {
        return length(a.position - b.position) < 1e-6;
    };
    for (std::size_t j = 0; j < steps.start.size(); ++j) {
        // The one that leapt is the one that follows.
        const auto leap = [&](std::size_t k) {
            return length(steps.before[k].position - steps.start[k].position);
        };
        if (j != i && isAt(steps.before[i], steps.before[j])
            && !isAt(steps.start[i], steps.start[j]) && leap(i) > leap(j))
            return static_cast<int>(j);
    }
    return -1;
}

/// Whether a fast circle does not lose what slow ones lose in a step.
bool keepsSpeed(const Flight &slow, const Steps &rest, const Steps &run, std::size_t i)
{
    if (!run.made)
        return false;
    const Vec2 kept = run.before[i].velocity - rest.before[i].velocity;
    return (slow.resetsX || std::abs(kept.y) > 0.5 * std::abs(run.start[i].velocity.y))
           && (slow.resetsY || std::abs(kept.x) > 0.5 * std::abs(run.start[i].velocity.x));
}

/// Compares a run that is late with one that is not.
void readLate(Flight &flight, const Steps &first, const Steps &late, std::size_t i)
{
    if (!late.made)
        return;
    const auto same = [](const Circle &a, const Circle &b) {
        return length(a.position - b.position) + length(a.velocity - b.velocity)
               <= 1e-9 * (1.0 + length(b.position) + length(b.velocity));
    };
    flight.isTimeless =
        same(first.before[i], late.before[i]) && same(first.after[i], late.after[i]);
    flight.lateWay = late.after[i].position - late.before[i].position;
    flight.lateVelocity = late.before[i].velocity;
    flight.firstWay = first.before[i].position - first.start[i].position;
    flight.lateFirstWay = late.before[i].position - late.start[i].position;
}

/// What falls fast must get the same from gravity as what does not.
void readFastFall(Flight &flight, const Steps &falling, double h, std::size_t i)
{
    if (!falling.made)
        return;
    const Circle &before = falling.before[i];
    const Vec2 turn = falling.after[i].velocity - before.velocity;
    const Vec2 expected = flight.after(before, h).velocity - before.velocity;
    // Only what gravity gives: anything else shows in the first step.
    if (length(turn) > 1e-9 || length(turn - expected) <= 1e-6)
        return;
    flight.isTurnLinear = false;
    flight.isKnown = false;
    flight.seen[1] = {before.velocity, falling.after[i].position - before.position, turn};
}

/// What the first step of a flight makes of its velocity, if it is not what the next ones do.
std::optional<Flight::Leap> leapOf(const Flight &flight, const Steps &run, double h, std::size_t i,
                                   bool isFast)
{
    if (!run.made)
        return std::nullopt;
    // A method that looks back has not seen a step yet.
    const double slack = 1e-6 + 2.0 * h * length(flight.acceleration);
    const Vec2 expected = flight.after(run.start[i], h).velocity;
    const Vec2 is = run.before[i].velocity;
    return length(is - expected) > slack
               ? std::optional(Flight::Leap{run.start[i].velocity, is, isFast})
               : std::nullopt;
}

} // namespace

Motion Flight::after(const Circle &c, double h) const
{
    const Vec2 v = c.velocity;
    return {c.position + h * Vec2{way.x * v.x, way.y * v.y} + drift,
            v + h * (Vec2{growth.x * v.x, growth.y * v.y} + acceleration)};
}

std::optional<double> Flight::share(double h) const
{
    const double a = lengthSquared(acceleration);
    if (a < 1e-12)
        return std::nullopt;
    return dot(drift, acceleration) / (a * h * h);
}

std::vector<Flight> measureFlights(const QString *program, const Ground &ground, Vec2 gravity,
                                   double h)
{
    std::vector<Flight> flights(ground.flights.size());
    const auto run = [&](Scene scene) {
        return fly(program, flightPreset(ground, gravity, h, scene));
    };
    const Steps rest = run(Scene::Rest);
    const Steps first = run(Scene::First);
    const Steps second = run(Scene::Second);
    const Steps shifted = run(Scene::Shifted);
    // What hangs on the moment or on the speed shows with any timestep: the further ones, of which
    // only the factors are compared, need not show it again.
    const bool isFurther =
        !ground.timesteps.empty() && h != ground.timesteps.front()
        && std::find(ground.timesteps.begin(), ground.timesteps.end(), h) != ground.timesteps.end();
    const Steps quick = isFurther ? Steps() : run(Scene::Fast);
    const Steps falling = isFurther || gravity == Vec2{} ? Steps() : run(Scene::Falling);
    const Steps late =
        isFurther ? Steps()
                  : fly(program, flightPreset(ground, gravity, h, Scene::First), lateSteps);
    if (!rest.made || !first.made || !second.made || !shifted.made) {
        // A program may stop where a circle rests, and tell enough where it moves.
        for (std::size_t i = 0; i < flights.size(); ++i) {
            flights[i].acceleration = gravity;
            flights[i].leap = leapOf(flights[i], first, h, i, false);
        }
        return flights;
    }
    for (std::size_t i = 0; i < flights.size(); ++i) {
        flights[i] = Reading(rest, first, second, shifted, h, i).read();
        flights[i].follows = followedBy(first, i);
        flights[i].borrows = borrowedBy(rest, first, second, i);
        readLate(flights[i], first, late, i);
        flights[i].isKnown = flights[i].isKnown && flights[i].follows < 0 && flights[i].borrows < 0
                             && flights[i].isTimeless;
        if (flights[i].isKnown) {
            flights[i].leap = leapOf(flights[i], first, h, i, false);
            if (!flights[i].leap)
                flights[i].leap = leapOf(flights[i], second, h, i, false);
            flights[i].isKnown = !flights[i].leap;
            if (flights[i].isKnown)
                readFastFall(flights[i], falling, h, i);
            if (!flights[i].leap)
                flights[i].leap = leapOf(flights[i], quick, h, i, true);
        }
        if (flights[i].resets || flights[i].resetsX || flights[i].resetsY)
            flights[i].onlySlow =
                keepsSpeed(flights[i], rest, isFurther ? run(Scene::Fast) : quick, i);
        if (!flights[i].isKnown || flights[i].way == Vec2{})
            flights[i].leader = leaderOf(program, ground, gravity, h, i, rest);
    }
    return flights;
}

std::optional<Vec2> measureHeavierFall(const QString *program, const Ground &ground, Vec2 gravity,
                                       double h, std::size_t i)
{
    Preset preset = flightPreset(ground, gravity, h, Scene::Rest);
    // The others stay as they are: its fall may hang on their masses, too.
    preset.circles[i].body.radius *= 1.25;
    preset.circles[i].body.density *= 1.5;
    const Steps steps = fly(program, preset);
    return steps.made ? std::optional((steps.after[i].velocity - steps.before[i].velocity) / h)
                      : std::nullopt;
}

Stage flightStage(const Ground &ground, Vec2 gravity, double h, bool fast)
{
    return {flightPreset(ground, gravity, h, fast ? Scene::Fast : Scene::First), true};
}

} // namespace cradle
