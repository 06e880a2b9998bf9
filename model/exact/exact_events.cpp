// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/exact_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// The search for events.

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A giant looks around for as long as it moves by this share of its radius.
constexpr double homeOfGiant = 0.25;
/// A bound is wider by this share, so that rounding cannot hide what is right at it.
constexpr double timeMargin = 1e-9;

/// Two discs as seen from the one when the later of the hits that they come from is over: from then
/// on they move straight, if they fall alike.
struct Encounter {
    double since = 0.0; ///< s into the epoch
    Vec2 d{};           ///< from the one to the other, m
    Vec2 v{};           ///< m/s

    /// Whether they come as near as \p distance (m) or nearly so.
    [[nodiscard]] bool mayMeet(double distance) const
    {
        const double across = cross(d, v);
        const bool closes = dot(d, v) < 0.0;
        const bool hits =
            across * across < (distance * distance) * ((1.0 + timeMargin) * lengthSquared(v));
        return closes & hits;
    }

    /// When they come as near as \p distance (m):
    ///     s = (d² − R²)/(−d·v + √D),   D = (d·v)² − v² (d² − R²) = R² v² − (d × v)²
    /// √D is R times the closing speed then. \param least  smaller D are none, m⁴/s²
    [[nodiscard]] double time(double distance, double least) const
    {
        const double square = distance * distance;
        const double gap = std::max(0.0, lengthSquared(d) - square);
        const double approach = -dot(d, v);
        const double across = cross(d, v);
        // Of the two forms of D the one in which less cancels.
        const double discriminant = gap < square ? approach * approach - lengthSquared(v) * gap
                                                 : square * lengthSquared(v) - across * across;
        return discriminant > least ? since + gap / (approach + std::sqrt(discriminant)) : infinity;
    }
};

template <bool Falling, class Disc>
Encounter encounterOf(const Disc &a, const Disc &b, [[maybe_unused]] Vec2 acceleration)
{
    const double since = std::max(a.clock, b.clock);
    const double s = since - a.clock;
    const double u = since - b.clock;
    Encounter e{since, (b.position + u * b.velocity) - (a.position + s * a.velocity),
                b.velocity - a.velocity};
    if constexpr (Falling) {
        e.d += (0.5 * (u * u - s * s)) * acceleration;
        e.v += (u - s) * acceleration;
    }
    return e;
}

/// When a point leaves the interval from \p low to \p high, in which it is but for rounding, s.
double timeToLeave(double place, double speed, double push, double low, double high)
{
    if (push < 0.0)
        return timeToLeave(-place, -speed, -push, -high, -low);
    const double back = speed * speed - 2.0 * push * std::max(0.0, place - low);
    if (speed < 0.0 && back > 0.0)
        return 2.0 * std::max(0.0, place - low) / (std::sqrt(back) - speed);
    return high < infinity
               ? timeToLine(high - place, speed, 0.5 * push, infinity).value_or(infinity)
               : infinity;
}

} // namespace

/// Takes note in \p plan of a hit on \p b, a disc or a wall, at \p time (s into the epoch).
void ExactSolver::note(Plan &plan, Slot b, double time) const
{
    if (time < plan.hit) {
        plan.then = plan.hit;
        plan.hit = std::max(time, m_eventTime);
        plan.partner = b;
        plan.partnerHits = isWall(b) ? 0 : m_discs[b].hits;
    } else if (b != plan.partner) {
        plan.then = std::min(plan.then, time);
    }
}

/// Where a wall holds one of two, the one falls as the other sees it: they meet, if ever, before it
/// has fallen farther than they are apart.
void ExactSolver::noteHitOfUnlike(Plan &plan, Slot a, Slot b) const
{
    Disc first = m_discs[a];
    Disc second = m_discs[b];
    const double since = std::max(first.clock, second.clock);
    carryTo(first, since);
    carryTo(second, since);
    const Path pathA{first.position, first.velocity, 0.5 * accelerationOf(first)};
    const Path pathB{second.position, second.velocity, 0.5 * accelerationOf(second)};
    const double distance = first.radius + second.radius;
    const double curve = std::sqrt(lengthSquared(pathB.curve - pathA.curve));
    const double speed = std::sqrt(lengthSquared(second.velocity - first.velocity));
    const double far = std::sqrt(lengthSquared(second.position - first.position)) + distance;
    // |k| s² = |v| s + |d| + R
    const double last = (speed + std::sqrt(speed * speed + 4.0 * curve * far)) / (2.0 * curve);
    const double end = std::min(last, plan.hit + m_moment - since);
    if (!(end >= 0.0))
        return;
    if (const auto s = timeToDistance(pathA, pathB, distance, end))
        note(plan, b, since + *s);
}

void ExactSolver::noteWallHit(Plan &plan, Slot a, Wall wall) const
{
    const Disc &disc = m_discs[a];
    if ((disc.held & heldBy(wall)) != 0)
        return;
    const Vec2 n = outwardNormal(wall);
    const double gap = m_rules.halfWidth - disc.radius - dot(disc.position, n);
    if (const auto s =
            timeToLine(gap, dot(disc.velocity, n), 0.5 * dot(accelerationOf(disc), n), infinity))
        note(plan, wallSlot(wall), disc.clock + *s);
}

/// Lists in m_near all that \p a may meet before it or they leave the cells in which they are
/// listed, but for giants. \return how many
std::size_t ExactSolver::listNear(Slot a)
{
    if (a < m_small)
        return m_cells.near(m_discs.data(), a, m_near.data());
    Disc disc = m_discs[a];
    carryTo(disc, m_eventTime);
    const double reach = ((1.0 + homeOfGiant) * disc.radius + m_smallRadius) * (1.0 + timeMargin);
    const Vec2 box{reach, reach};
    return m_cells.within(m_discs.data(), disc.position - box, disc.position + box, m_near.data());
}

/// Appends the giants to the first \p count of m_near. \return how many it holds then
std::size_t ExactSolver::listGiants(std::size_t count)
{
    for (auto giant = static_cast<Slot>(m_small); giant < m_discs.size(); ++giant)
        m_near[count++] = giant;
    return count;
}

/// Completes the plan of \p a: hits on those of the first \p count of m_near that come at or after
/// \p from, and when it leaves its cell.
template <bool Falling>
void ExactSolver::complete(Slot a, Plan &plan, std::size_t count, Slot from)
{
    const Disc &first = m_discs[a];
    const Vec2 acceleration = Falling ? accelerationOf(first) : Vec2{};
    const Disc *discs = m_discs.data();
    Slot *near = m_near.data();
    // Without branches, as most pass each other.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Slot b = near[i];
        const Disc &second = discs[b];
        const double distance = first.radius + second.radius;
        bool mayMeet = encounterOf<Falling>(first, second, acceleration).mayMeet(distance);
        if constexpr (Falling)
            mayMeet = mayMeet | (first.held != second.held);
        near[kept] = b;
        kept += (mayMeet & (b >= from)) ? 1 : 0;
    }
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < kept; ++i) {
        const Slot b = near[i];
        const Disc &second = discs[b];
        if (Falling && first.held != second.held) {
            near[unlike++] = b;
            continue;
        }
        const double distance = first.radius + second.radius;
        const double least = roundedSpeed * distance;
        const double speeds = lengthSquared(first.velocity) + lengthSquared(second.velocity);
        note(plan, b,
             encounterOf<Falling>(first, second, acceleration)
                 .time(distance, least * least * speeds));
    }
    // These are dear, and cheaper the sooner something else comes first.
    for (std::size_t i = 0; i < unlike; ++i)
        noteHitOfUnlike(plan, a, near[i]);
    planLeaving<Falling>(a, plan);
    m_discs[a].plan = plan;
    m_queue.set(a, std::min(plan.hit, plan.leave));
}

/// When \p a leaves the cell in which it is listed; a giant, a box around it.
template <bool Falling>
void ExactSolver::planLeaving(Slot a, Plan &plan) const
{
    const Disc &disc = m_discs[a];
    const double s = m_eventTime - disc.clock;
    const Vec2 acceleration = Falling ? accelerationOf(disc) : Vec2{};
    const Vec2 p = disc.position + s * (disc.velocity + (0.5 * s) * acceleration);
    const Vec2 v = disc.velocity + s * acceleration;
    const double home = homeOfGiant * disc.radius;
    const bool listed = a < m_small;
    const auto across = [&](bool right) {
        return listed ? m_cells.endAcross(disc.link, right) : p.x + (right ? home : -home);
    };
    const auto along = [&](bool top) {
        return listed ? m_cells.endAlong(disc.link, top) : p.y + (top ? home : -home);
    };
    const auto wait = [](double place, double speed, double push, auto end) {
        if (Falling && push != 0.0)
            return timeToLeave(place, speed, push, end(false), end(true));
        // Not quite zero, so that what rests never leaves.
        const double gap =
            std::max(std::abs(end(speed > 0.0) - place), std::numeric_limits<double>::min());
        return gap / std::abs(speed);
    };
    const double x = wait(p.x, v.x, acceleration.x, across);
    const double y = wait(p.y, v.y, acceleration.y, along);
    plan.leave = m_eventTime + std::min(x, y);
    const bool right = v.x + x * acceleration.x > 0.0;
    const bool top = v.y + y * acceleration.y > 0.0;
    static_assert(static_cast<int>(Wall::Right) == 1 && static_cast<int>(Wall::Bottom) == 2);
    plan.side = static_cast<Wall>(x < y ? int{right} : 2 + int{top});
}

void ExactSolver::findEventsFrom(Slot a, Slot from)
{
    Plan plan;
    if (m_walls) {
        const unsigned edges = a < m_small ? m_cells.edgesOf(m_discs[a].link) : ~0U;
        for (const Wall wall : allWalls) {
            if (edges == 0)
                break;
            if ((edges & heldBy(wall)) != 0)
                noteWallHit(plan, a, wall);
        }
    }
    const std::size_t count = m_pairs ? listGiants(listNear(a)) : 0;
    if (m_gravity > 0.0)
        complete<true>(a, plan, count, from);
    else
        complete<false>(a, plan, count, from);
}

void ExactSolver::findEvents(Slot a)
{
    findEventsFrom(a, 0);
}

void ExactSolver::findFirstEvents()
{
    m_queue.reset(std::max<std::size_t>(m_discs.size(), 1));
    for (Slot a = 0; a < m_discs.size(); ++a)
        findEventsFrom(a, a + 1);
}

/// Lists \p a in the next cell and looks for what it can meet there that it could not before.
void ExactSolver::cross(Slot a)
{
    ++m_crossings;
    if (a >= m_small) {
        findEvents(a);
        return;
    }
    Plan plan = m_discs[a].plan;
    m_cells.move(m_discs.data(), a, plan.side);
    if (m_walls && (m_cells.edgesOf(m_discs[a].link) & heldBy(plan.side)) != 0)
        noteWallHit(plan, a, plan.side);
    const std::size_t count =
        m_pairs ? listGiants(m_cells.ahead(m_discs.data(), a, plan.side, m_near.data())) : 0;
    if (m_gravity > 0.0)
        complete<true>(a, plan, count, 0);
    else
        complete<false>(a, plan, count, 0);
}

} // namespace cradle
