// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_leader.h"

namespace cradle::flights {

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

bool startsFrom(const Steps &run, std::size_t j, std::size_t i)
{
    const auto way = [&](std::size_t k) {
        return length(run.before[i].position - run.start[k].position);
    };
    return run.made && way(j) < way(i);
}

int placedBy(const Steps &first, const Steps &second, std::size_t i)
{
    constexpr double near = 0.3; // m: more than a step's way, and than what a hit pushes it aside
    const auto isBeside = [&](const Steps &run, std::size_t j) {
        const auto from = [&](std::size_t k) {
            return length(run.before[i].position - run.start[k].position);
        };
        return run.made && from(j) < near && from(i) > 3.0 * near;
    };
    for (std::size_t j = 0; j < first.start.size(); ++j) {
        if (j != i && isBeside(first, j) && isBeside(second, j))
            return static_cast<int>(j);
    }
    return -1;
}

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

} // namespace cradle::flights
