// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_flight.h"

#include "tasks/judging/flight_reading.h"
#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

MeasuredFlight::MeasuredFlight(const QString *program, const Ground &ground)
    : m_program(program)
    , m_ground(ground)
{
    Probe probe(program, {ground.own, false});
    m_own.scene = probe.start();
    if (!probe.runs())
        return;
    const std::vector<Circle> before = probe.world().circles;
    if (!probe.step())
        return;
    const std::vector<Circle> between = probe.world().circles;
    const bool goesOn = probe.step();
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec2 first = between[i].velocity - before[i].velocity;
        const Vec2 second =
            goesOn ? probe.world().circles[i].velocity - between[i].velocity : Vec2{};
        m_own.ways.push_back(between[i].position - before[i].position);
        m_own.accelerations.push_back(first / m_own.scene.timestep);
        m_own.later.push_back(second / m_own.scene.timestep);
    }
}

std::optional<Vec2> MeasuredFlight::ownFallElsewhere(int i) const
{
    auto probe = ownWith([](Circle &c, int, Vec2 place) {
        c.position = place;
        c.velocity = {};
    });
    return probe && probe->step() ? nextFall(*probe, i) : std::nullopt;
}

std::optional<Vec2> MeasuredFlight::ownFallApart(int i) const
{
    auto probe = ownWith([i](Circle &c, int circle, Vec2 place) {
        if (circle != i)
            c.position = place;
    });
    return probe ? nextFall(*probe, i) : std::nullopt;
}

std::unique_ptr<Probe>
MeasuredFlight::ownWith(const std::function<void(Circle &, int circle, Vec2 place)> &set) const
{
    auto probe = std::make_unique<Probe>(m_program, Stage{m_ground.own, false});
    if (!probe->runs())
        return nullptr;
    World world = probe->world();
    const Preset stage = m_ground.stage();
    for (std::size_t k = 0; k < std::min(world.circles.size(), stage.circles.size()); ++k)
        set(world.circles[k], static_cast<int>(k), stage.circles[k].body.position);
    probe->place(world);
    return probe;
}

std::optional<Vec2> MeasuredFlight::nextFall(Probe &probe, int i) const
{
    const Vec2 before = probe.circle(i).velocity;
    return probe.step() ? std::optional((probe.circle(i).velocity - before) / m_own.scene.timestep)
                        : std::nullopt;
}

const std::vector<Flight> &MeasuredFlight::at(Vec2 gravity, double h) const
{
    const auto known =
        std::find_if(m_measured.begin(), m_measured.end(), [&](const auto &measured) {
            return measured->gravity == gravity && measured->timestep == h;
        });
    if (known != m_measured.end())
        return (*known)->flights;
    m_measured.push_back(std::make_unique<const Measured>(
        Measured{gravity, h, measureFlights(m_program, m_ground, gravity, h)}));
    return m_measured.back()->flights;
}

std::optional<Vec2> MeasuredFlight::heavierFall(Vec2 gravity, double h, int i) const
{
    const auto step =
        measureHeavierFall(m_program, m_ground, gravity, h, static_cast<std::size_t>(i));
    if (!step)
        return std::nullopt;
    const Vec2 growth = at(gravity, h, i).growth;
    return step->turn / h - Vec2{growth.x * step->velocity.x, growth.y * step->velocity.y};
}

std::optional<Flight::Step> MeasuredFlight::whileOthersRest(Vec2 gravity, double h, int i) const
{
    return m_ground.flights.size() < 2 ? std::nullopt
                                       : measureWhileOthersRest(m_program, m_ground, gravity, h,
                                                                static_cast<std::size_t>(i));
}

std::optional<Flight::Step> MeasuredFlight::withRestitution(Vec2 gravity, double h, int i,
                                                            double restitution) const
{
    return measureWithRestitution(m_program, m_ground, gravity, h, static_cast<std::size_t>(i),
                                  restitution);
}

std::optional<Flight::Step> MeasuredFlight::slowStart(double slower, double h, int i) const
{
    return measureSlowStart(m_program, m_ground, slower, h, static_cast<std::size_t>(i));
}

bool MeasuredFlight::beginsLike(const MeasuredFlight &other) const
{
    constexpr int steps = 6;
    if (m_ground.gravities.empty() || m_ground.timesteps.empty())
        return true;
    const double h = m_ground.timesteps.front();
    for (std::size_t i = 0; i < m_ground.flights.size(); ++i) {
        const auto of = [&](const MeasuredFlight &flight) {
            return flight.firstSteps(m_ground.gravities.front(), h, static_cast<int>(i),
                                     FirstSteps::Going, steps);
        };
        const std::vector<Flight::Step> ours = of(*this);
        const std::vector<Flight::Step> theirs = of(other);
        if (!std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                        [&](const Flight::Step &a, const Flight::Step &b) {
                            return isAlike(a.turn, b.turn) && isAlike(a.way / h, b.way / h);
                        }))
            return false;
    }
    return true;
}

bool MeasuredFlight::isLike(const MeasuredFlight &other) const
{
    for (const Vec2 gravity : m_ground.gravities) {
        for (const double h : m_ground.timesteps) {
            for (std::size_t i = 0; i < m_ground.flights.size(); ++i) {
                const int circle = static_cast<int>(i);
                const Flight &a = at(gravity, h, circle);
                const Flight &b = other.at(gravity, h, circle);
                if (!isAlike(a.way, b.way) || !isAlike(a.acceleration, b.acceleration)
                    || !isAlike(a.growth, b.growth) || !isAlike(a.pull, b.pull)
                    || !isAlike(a.drift / (h * h), b.drift / (h * h)) || a.jumps != b.jumps
                    || a.isOfStart != b.isOfStart || a.xFollows != b.xFollows
                    || a.yFollows != b.yFollows || a.resets != b.resets || a.resetsX != b.resetsX
                    || a.resetsY != b.resetsY || !isAlike(a.carried, b.carried)
                    || a.leader != b.leader || a.follows != b.follows || a.borrows != b.borrows
                    || a.onlySlow != b.onlySlow || a.isTimeless != b.isTimeless
                    || a.leap.has_value() != b.leap.has_value() || a.isWayLinear != b.isWayLinear
                    || a.isTurnLinear != b.isTurnLinear || !isAlike(a.turnedInto, b.turnedInto)
                    || !isAlike(a.wayMade, b.wayMade) || !isAlike(a.firstWay, b.firstWay))
                    return false;
            }
        }
    }
    for (std::size_t i = 0;
         i < std::min(m_own.accelerations.size(), other.m_own.accelerations.size()); ++i) {
        if (!isAlike(m_own.accelerations[i], other.m_own.accelerations[i]))
            return false;
    }
    return beginsLike(other);
}

} // namespace cradle
