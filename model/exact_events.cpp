// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cradle {

// The search for events.

namespace {

/// A closing speed below this share of the speeds is rounding: two that touch move alike.
constexpr double roundedSpeed = 1e-13;
/// Discs that one may meet on the average at the start of an epoch before its drift is made
/// shorter, by this factor, down to so many radii.
constexpr double crowded = 20.0;
constexpr double shorter = 0.75;
constexpr double leastDrift = 0.5;
} // namespace

void ExactSolver::push(double time, Slot a, Slot b)
{
    m_events.push_back({.time = time,
                        .a = a,
                        .b = b,
                        .hitsA = m_discs[a].hits,
                        .hitsB = isDisc(b) ? m_discs[b].hits : 0});
    std::push_heap(m_events.begin(), m_events.end(), later);
}

ExactSolver::Event ExactSolver::pop()
{
    const Event event = m_events.front();
    std::pop_heap(m_events.begin(), m_events.end(), later);
    m_events.pop_back();
    return event;
}

/// Looks for hits of \p a, which is at the present event's time, with the discs that \p visitRuns
/// hands out. \p Falling: there is gravity, and discs may rest. \p Fresh: all clocks are at 0.
template <bool Falling, bool Fresh, class VisitRuns>
void ExactSolver::search(Slot a, VisitRuns visitRuns)
{
    constexpr std::size_t most = 64;
    std::array<Slot, most> near;
    std::size_t count = 0;
    const auto look = [&] {
        for (std::size_t k = 0; k < count; ++k)
            findPairEvent(a, near[k]);
        count = 0;
    };
    const Disc first = m_discs[a];
    const Disc *discs = m_discs.data();
    const Vec2 g = m_rules.gravity;
    const double time = m_eventTime;
    const double span = 2.0 * (m_horizon - time);
    // Without branches, as most cannot meet within the epoch: their distance at s is at least
    // √(d² − 2 s approach).
    visitRuns([&](Slot begin, Slot end) {
        for (Slot b = begin; b < end; ++b) {
            const Disc &second = discs[b];
            Vec2 v = second.velocity;
            Vec2 d = second.position - first.position;
            if constexpr (!Fresh) {
                const double s = time - second.clock;
                if constexpr (Falling) {
                    d += s * (v + (0.5 * s) * g);
                    v += s * g;
                } else {
                    d += s * v;
                }
            }
            const double sum = first.radius + second.radius;
            bool mayMeet = lengthSquared(d) - sum * sum < span * dot(d, first.velocity - v);
            if constexpr (Falling)
                mayMeet = mayMeet || (first.held | second.held) != 0;
            if constexpr (!Fresh)
                mayMeet = mayMeet && b != a;
            near[count] = b;
            count += mayMeet ? 1 : 0;
            if (count == most)
                look();
        }
    });
    look();
}

void ExactSolver::findFirstEvents()
{
    m_horizon = m_epochEnd;
    if (m_walls) {
        for (Slot a = 0; a < m_discs.size(); ++a)
            findWallEvent(a);
    }
    if (m_pairs && m_gravity > 0.0)
        findFirstPairs<true>();
    else if (m_pairs)
        findFirstPairs<false>();
}

template <bool Falling>
void ExactSolver::findFirstPairs()
{
    const auto small = static_cast<Slot>(m_small);
    const auto all = static_cast<Slot>(m_discs.size());
    std::size_t met = 0;
    for (Slot a = 0; a < all; ++a) {
        search<Falling, true>(a, [&](auto look) {
            if (a < small) {
                const Disc &disc = m_discs[a];
                const double reach = disc.radius + m_smallRadius + m_drift + travelOf(disc);
                m_grid.visitRunsAfter(a, disc.position, reach, [&](Slot begin, Slot end) {
                    met += end - std::min(begin, end);
                    look(begin, end);
                });
            }
            look(std::max(a + 1, small), all);
        });
    }
    // Where it is crowded shorter epochs are cheaper; the searches of this one rely on its drift.
    const double share = static_cast<double>(met) / std::max(1.0, static_cast<double>(all));
    if (share > crowded)
        m_nextDrift = std::max(shorter * m_drift, leastDrift * m_smallRadius);
    else if (share < shorter * shorter * shorter * crowded)
        m_nextDrift = std::min(m_drift / shorter, m_widestDrift);
}

void ExactSolver::findEvents(Slot a)
{
    // Discs in a lasting contact will be hit again soon: farther on is not worth the search.
    m_horizon = shakes(a) ? std::min(m_epochEnd, m_eventTime + m_lastingSearch) : m_epochEnd;
    if (m_horizon < m_epochEnd)
        push(m_horizon, a, lookAgain);
    if (m_walls)
        findWallEvent(a);
    if (!m_pairs)
        return;
    const Disc &disc = m_discs[a];
    const double reach = disc.radius + m_smallRadius + m_drift + travelOf(disc);
    const auto neighbours = [&](auto look) {
        m_grid.visitRuns(disc.position, reach, look);
        look(static_cast<Slot>(m_small), static_cast<Slot>(m_discs.size()));
    };
    if (m_gravity > 0.0)
        search<true, false>(a, neighbours);
    else
        search<false, false>(a, neighbours);
}

/// How far a disc can come before events are looked for again, m.
double ExactSolver::travelOf(const Disc &disc) const
{
    const double left = m_horizon - m_eventTime;
    const double speed = std::sqrt(lengthSquared(disc.velocity));
    return std::min(2.0 * m_drift, left * (speed + 0.5 * left * m_gravity));
}

void ExactSolver::findWallEvent(Slot a)
{
    const Disc &disc = m_discs[a];
    const double room = m_rules.halfWidth - disc.radius;
    const double safe = room - 2.0 * m_drift;
    if (std::abs(disc.position.x) < safe && std::abs(disc.position.y) < safe)
        return;
    const Vec2 acceleration = accelerationOf(disc);
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        if ((disc.held & heldBy(wall)) != 0)
            continue;
        const auto s = timeToLine(room - dot(disc.position, n), dot(disc.velocity, n),
                                  0.5 * dot(acceleration, n), m_horizon - m_eventTime);
        if (s)
            push(m_eventTime + *s, a, wallSlot(wall));
    }
}

/// \p a is at the present event's time, \p b at its own clock.
void ExactSolver::findPairEvent(Slot a, Slot b)
{
    const Disc &first = m_discs[a];
    const Disc &second = m_discs[b];
    const double s = m_eventTime - second.clock;
    const double left = m_horizon - m_eventTime;
    const double distance = first.radius + second.radius;
    if (first.held != second.held) {
        Disc other = second;
        carryTo(other, m_eventTime);
        const Path pathA{first.position, first.velocity, 0.5 * accelerationOf(first)};
        const Path pathB{other.position, other.velocity, 0.5 * accelerationOf(other)};
        if (const auto meeting = timeToDistance(pathA, pathB, distance, left))
            push(m_eventTime + *meeting, a, b);
        return;
    }
    // Both fall alike: the one moves straight as the other sees it.
    const Vec2 g = first.held == 0 ? m_rules.gravity : accelerationOf(second);
    const Vec2 v = second.velocity - first.velocity + s * g;
    const Vec2 d = second.position - first.position + s * (second.velocity + (0.5 * s) * g);
    const double approach = -dot(d, v);
    const double gap = std::max(0.0, lengthSquared(d) - distance * distance);
    if (approach <= 0.0 || gap > 2.0 * left * approach)
        return;
    const double discriminant = approach * approach - lengthSquared(v) * gap;
    const double least = roundedSpeed * distance;
    if (discriminant
        <= least * least * (lengthSquared(first.velocity) + lengthSquared(second.velocity)))
        return;
    const double meeting = gap / (approach + std::sqrt(discriminant));
    if (meeting <= left)
        push(m_eventTime + meeting, a, b);
}

} // namespace cradle
