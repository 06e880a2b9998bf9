// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_reading.h"

#include "tasks/judging/flight_leader.h"
#include "tasks/judging/flight_scenes.h"
#include "tasks/judging/steps_reading.h"

#include <algorithm>

namespace cradle {

namespace {

using namespace flights;

/// Whether a fast circle does not lose what slow ones lose in a step.
bool keepsSpeed(const Flight &slow, const Steps &rest, const Steps &run, std::size_t i)
{
    if (!run.made)
        return false;
    const Vec2 kept = run.before[i].velocity - rest.before[i].velocity;
    return (slow.resetsX || std::abs(kept.y) > 0.5 * std::abs(run.start[i].velocity.y))
           && (slow.resetsY || std::abs(kept.x) > 0.5 * std::abs(run.start[i].velocity.x));
}

/// Where the other of two circles stands, far from circle \p i, so that what stops that one
/// elsewhere lets it go on: then the place of the other is what the program asks.
std::optional<Vec2> freedBy(const QString *program, const Ground &ground, Vec2 gravity, double h,
                            std::size_t i, const Steps &rest)
{
    static constexpr Vec2 places[] = {
        {0.07, -0.11}, {3.13, 2.91}, {-2.87, 3.07}, {2.93, -3.19}, {-3.11, -2.83}};
    Preset preset = flightPreset(ground, gravity, h, Scene::First);
    if (preset.circles.size() != 2)
        return std::nullopt;
    for (const Vec2 place : places) {
        preset.circles[1 - i].body.position = place;
        const Steps run = fly(program, preset);
        const auto kept = [&] { return run.before[i].velocity - rest.before[i].velocity; };
        if (run.made && length(kept() - run.start[i].velocity) < 1e-9)
            return place;
    }
    return std::nullopt;
}

/// Whether the velocity of circle \p i, the same after the first step however it started, becomes
/// another one, by what gravity gives or at a wall, and later steps go on from that. What is set
/// anew in each is not carried from one to the next.
bool keepsOwnVelocity(const QString *program, const Preset &preset, const Flight &flight,
                      const Steps &first, std::size_t i)
{
    constexpr int steps = 600;
    const Vec2 turn = first.after[i].velocity - first.before[i].velocity;
    const auto part = [&](Vec2 v) {
        return Vec2{flight.resetsY ? 0.0 : v.x, flight.resetsX ? 0.0 : v.y};
    };
    const Vec2 set = first.before[i].velocity;
    Probe probe(program, {preset, true});
    for (int k = 1; k <= steps; ++k) {
        const Circle was = probe.circle(static_cast<int>(i));
        if (!probe.step())
            return false;
        const Circle &now = probe.circle(static_cast<int>(i));
        // What a wall turns again in every step stays where it is.
        const bool moves =
            goesByVelocity(part(now.position - was.position), part(was.velocity), preset.timestep);
        if (k > 1 && moves && length(part(was.velocity - set)) > 1e-6
            && length(part(now.velocity - was.velocity - turn)) <= 1e-9)
            return true;
    }
    return false;
}

/// Whether circle \p i leaves the place where it is after the first step however it started, and
/// then goes on by its velocity. What every step puts there comes back.
bool leavesOwnPlace(const QString *program, const Preset &preset, std::size_t i)
{
    constexpr int steps = 600;
    constexpr int enough = 3; // steps that go on
    const int circle = static_cast<int>(i);
    Probe probe(program, {preset, true});
    int gone = 0;
    for (int k = 0; k < steps && gone < enough; ++k) {
        const Circle was = probe.circle(circle);
        if (!probe.step())
            return false;
        const Vec2 way = probe.circle(circle).position - was.position;
        const bool goesOn = k > 0 && goesByVelocity(way, was.velocity, preset.timestep);
        gone = goesOn ? gone + 1 : 0;
    }
    return gone >= enough;
}

/// Whether circle \p i goes the same two steps in both.
bool areSame(const Steps &a, const Steps &b, std::size_t i)
{
    const auto same = [](const Circle &one, const Circle &other) {
        return length(one.position - other.position) + length(one.velocity - other.velocity)
               <= 1e-9 * (1.0 + length(other.position) + length(other.velocity));
    };
    return same(a.before[i], b.before[i]) && same(a.after[i], b.after[i]);
}

/// Compares a run that is late with one that is not.
void readLate(Flight &flight, const Steps &first, const Steps &late, std::size_t i)
{
    if (!late.made)
        return;
    flight.isTimeless = areSame(first, late, i);
    flight.lateWay = late.after[i].position - late.before[i].position;
    flight.lateVelocity = late.before[i].velocity;
    flight.lateFirstWay = late.before[i].position - late.start[i].position;
}

/// What is fast, or goes the other way, must go by its velocity as the first one does.
void readOtherWay(Flight &flight, const Steps &run, double h, std::size_t i)
{
    const auto step = secondStep(run, i);
    if (!step || length(run.after[i].position - flight.after(run.before[i], h).position) <= 1e-6)
        return;
    flight.isWayLinear = false;
    flight.isWayOfNew &= length(step->way - h * (step->velocity + step->turn)) <= 1e-6;
    flight.isKnown = false;
    flight.seen[1] = *step;
}

/// Whether both go v h, but for what gravity makes in a step: what rests is not known.
void readWays(Flight &flight, const std::array<Steps, 2> &runs, double fall, double h,
              std::size_t i)
{
    for (std::size_t k = 0; k < runs.size(); ++k) {
        flight.seen[k] = secondStep(runs[k], i).value_or(Flight::Step{});
        flight.isWayLinear &=
            length(flight.seen[k].way - h * flight.seen[k].velocity) <= 1e-6 + 1.01 * fall;
    }
}

/// What falls fast must get the same from gravity as what does not.
void readFastFall(Flight &flight, const Steps &falling, double h, std::size_t i)
{
    const auto step = secondStep(falling, i);
    // Only what gravity gives: anything else shows in the first step.
    if (!step || length(step->turn) > 1e-9
        || length(falling.after[i].velocity - flight.after(falling.before[i], h).velocity) <= 1e-6)
        return;
    flight.isTurnLinear = false;
    flight.isKnown = false;
    flight.seen[1] = *step;
}

/// What the first step of a flight makes of its velocity, if it is not what the next ones do.
std::optional<Flight::Leap> leapOf(const Flight &flight, const Steps &run, double h, std::size_t i,
                                   Flight::Speed speed = Flight::Speed::Any)
{
    if (!run.made)
        return std::nullopt;
    // A method that looks back has not seen a step yet.
    const double slack = 1e-6 + 2.0 * h * length(flight.acceleration);
    const Vec2 expected = flight.after(run.start[i], h).velocity;
    const Vec2 is = run.before[i].velocity;
    return length(is - expected) > slack
               ? std::optional(Flight::Leap{run.start[i].velocity, is, speed})
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
    const FlownSteps steps{run(Scene::Rest), run(Scene::First), run(Scene::Second),
                           run(Scene::Shifted)};
    const Steps &rest = steps.rest;
    const Steps &first = steps.first;
    const Steps &second = steps.second;
    // What hangs on the moment or on the speed shows with any timestep: the further ones, of which
    // only the factors are compared, need not show it again.
    const bool isFurther =
        !ground.timesteps.empty() && h != ground.timesteps.front()
        && std::find(ground.timesteps.begin(), ground.timesteps.end(), h) != ground.timesteps.end();
    const Steps quick = isFurther ? Steps() : run(Scene::Fast);
    const Steps creeping = isFurther ? Steps() : run(Scene::Slow);
    const Steps back = isFurther ? Steps() : run(Scene::Back);
    const Steps falling = isFurther || gravity == Vec2{} ? Steps() : run(Scene::Falling);
    const Steps late =
        isFurther ? Steps()
                  : fly(program, flightPreset(ground, gravity, h, Scene::First), lateSteps);
    if (!steps.areMade()) {
        // A program may stop where a circle rests, and tell enough where it moves.
        for (std::size_t i = 0; i < flights.size(); ++i) {
            flights[i].acceleration = gravity;
            flights[i].startedWith = first.start[i].velocity;
            flights[i].seen[0] = secondStep(first, i).value_or(Flight::Step{});
            flights[i].leap = leapOf(flights[i], first, h, i);
            flights[i].leader = placedBy(first, second, i);
            flights[i].isFromLeader = flights[i].leader >= 0;
            if (first.made && second.made)
                readWays(flights[i], {first, second}, length(gravity) * h * h, h, i);
        }
        return flights;
    }
    for (std::size_t i = 0; i < flights.size(); ++i) {
        flights[i] = lawOf(steps, h, i);
        flights[i].follows = followedBy(first, i);
        flights[i].borrows = borrowedBy(rest, first, second, i);
        flights[i].leader = placedBy(first, second, i);
        flights[i].isFromLeader = flights[i].leader >= 0;
        readLate(flights[i], first, late, i);
        for (const qint64 more : {1, 2}) {
            if (flights[i].isTimeless || flights[i].isCounted)
                break;
            const Steps later =
                fly(program, flightPreset(ground, gravity, h, Scene::First), lateSteps + more);
            flights[i].isCounted = later.made && areSame(first, later, i);
        }
        flights[i].isKnown = flights[i].isKnown && flights[i].follows < 0 && flights[i].borrows < 0
                             && flights[i].isTimeless && !flights[i].isFromLeader;
        if (flights[i].isKnown) {
            flights[i].leap = leapOf(flights[i], first, h, i);
            if (!flights[i].leap)
                flights[i].leap = leapOf(flights[i], second, h, i);
            flights[i].isKnown = !flights[i].leap;
            if (flights[i].isKnown)
                readFastFall(flights[i], falling, h, i);
            if (!flights[i].leap)
                flights[i].leap = leapOf(flights[i], quick, h, i, Flight::Speed::Fast);
            if (!flights[i].leap)
                flights[i].leap = leapOf(flights[i], creeping, h, i, Flight::Speed::Slow);
            if (!flights[i].leap)
                flights[i].leap = leapOf(flights[i], falling, h, i, Flight::Speed::Fast);
            for (const Steps *other : {&quick, &back}) {
                if (!flights[i].leap && flights[i].isWayLinear)
                    readOtherWay(flights[i], *other, h, i);
            }
        }
        if (flights[i].resets || flights[i].resetsX || flights[i].resetsY) {
            const auto keeps = [&](const Steps &flown) {
                return keepsSpeed(flights[i], rest, flown, i);
            };
            // It is the speed only where the places to which it comes are not to blame.
            flights[i].onlySlow = keeps(isFurther ? run(Scene::Fast) : quick)
                                  && keeps(run(Scene::Behind)) && !keeps(run(Scene::Ahead));
        }
        if ((flights[i].resets || flights[i].resetsX || flights[i].resetsY) && !isFurther)
            flights[i].keepsOwnVelocity = keepsOwnVelocity(
                program, flightPreset(ground, gravity, h, Scene::First), flights[i], first, i);
        if (flights[i].jumps && !flights[i].keepsOwnPlace && !isFurther)
            flights[i].keepsOwnPlace =
                leavesOwnPlace(program, flightPreset(ground, gravity, h, Scene::First), i);
        if (flights[i].resets && !isFurther)
            flights[i].freedBy = freedBy(program, ground, gravity, h, i, rest);
        if (flights[i].isFromLeader)
            continue;
        if (!flights[i].isKnown || flights[i].way == Vec2{})
            flights[i].leader = leaderOf(program, ground, gravity, h, i, rest);
        if (flights[i].leader >= 0)
            flights[i].isFromLeader =
                startsFrom(fly(program, flightPreset(ground, gravity, h, Scene::Apart, i)),
                           static_cast<std::size_t>(flights[i].leader), i);
    }
    return flights;
}

} // namespace cradle
