// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/exact_solver.h"

#include "model/contacts/disc_grid.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// An epoch lasts for so many hits, and so many a disc: its times stay short, so that they keep
/// their digits, and its order stays near to that of the places.
constexpr std::size_t hitsOfEpoch = 8;
/// Discs are listed anew after so many changes of cell for each, as without walls they spread.
constexpr std::size_t crossingsOfList = 64;
/// Rounding of places and speeds parts hits of one moment by less than this many of their units.
constexpr double roundings = 64.0 * std::numeric_limits<double>::epsilon();
/// More contacts that last than this in so many seconds of the scene are a heap that hops by the
/// million: each takes about a microsecond, all of them half of the time that they fill.
constexpr std::size_t mostLasting = 8192;
constexpr double window = 1.0 / 64.0;
/// Without gravity: hits below this share of the speed that there was at the start lose nothing.
constexpr double quietShare = 1e-6;

} // namespace

void ExactSolver::start(const Rules &rules, std::span<const Circle> circles)
{
    m_rules = {.halfWidth = rules.halfWidth,
               .gravity = rules.gravity,
               .restitution = rules.restitution,
               .laws = rules.laws};
    m_gravity = length(rules.gravity);
    m_walls = rules.laws.walls == WallLaw::Reflect;
    m_pairs = rules.laws.circles != CircleLaw::None;
    m_lossy = rules.restitution < 1.0 || rules.laws.circles == CircleLaw::Stop;
    const std::size_t count = circles.size();
    m_discs.clear();
    m_discs.reserve(count);
    GiantsApart apart = giantsApart(circles);
    for (const std::uint32_t id : apart.ids)
        m_discs.push_back({.position = circles[id].position,
                           .velocity = circles[id].velocity,
                           .radius = circles[id].radius,
                           .inverseMass = 1.0 / mass(circles[id])});
    m_ids = std::move(apart.ids);
    m_small = apart.small;
    m_smallRadius = apart.smallRadius;
    setScales();
    m_shaking.assign(m_lossy ? count : 0, false);
    m_near.resize(count + 1);
    m_now = 0.0;
    m_eventTime = 0.0;
    m_elapsed = 0.0;
    m_windowEnd = 0.0;
    m_lasting = 0;
    m_collapsed = false;
    m_left = 0.0;
    beginEpoch();
}

/// What is slow in this crowd.
void ExactSolver::setScales()
{
    Vec2 mean{};
    double squares = 0.0;
    const auto count = static_cast<double>(std::max<std::size_t>(m_discs.size(), 1));
    m_rows = std::floor(std::sqrt(count));
    for (const Disc &disc : m_discs) {
        mean += disc.velocity / count;
        squares += lengthSquared(disc.velocity) / count;
    }
    m_quiet = quietShare * std::sqrt(std::max(0.0, squares - lengthSquared(mean)));
}

/// Of a disc that rests on one wall or two.
Vec2 ExactSolver::accelerationHeld(const Disc &disc) const
{
    Vec2 a = m_rules.gravity;
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        if ((disc.held & heldBy(wall)) != 0)
            a -= dot(a, n) * n;
    }
    return a;
}

/// Carries all discs to the present event and counts time from there.
void ExactSolver::beginEpoch()
{
    double extent = m_rules.halfWidth;
    double fastest = 0.0;
    for (Disc &disc : m_discs) {
        carryTo(disc, m_eventTime);
        disc.clock = 0.0;
        extent = std::max({extent, std::abs(disc.position.x), std::abs(disc.position.y)});
        fastest = std::max(fastest, lengthSquared(disc.velocity));
    }
    m_now -= m_eventTime;
    m_startTime += m_eventTime;
    m_elapsed += m_eventTime;
    m_eventTime = 0.0;
    m_hits = 0;
    const double speed = std::sqrt(fastest + 2.0 * m_gravity * extent);
    m_moment = speed > 0.0 ? roundings * extent / speed : 0.0;
    listDiscs();
}

/// Lists the discs where they are now, in the order of the cells. What is foreseen stays the same.
void ExactSolver::listDiscs()
{
    Vec2 low{-m_rules.halfWidth, -m_rules.halfWidth};
    Vec2 high = -low;
    const auto placeOf = [this](Slot slot) {
        Disc disc = m_discs[slot];
        carryTo(disc, m_eventTime);
        return disc.position;
    };
    if (!m_walls && m_small > 0) {
        low = high = placeOf(0);
        for (Slot slot = 1; slot < m_small; ++slot) {
            const Vec2 p = placeOf(slot);
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    }
    for (const bool inOrder : {false, true}) {
        m_cells.divide(low, high, m_small, 2.0 * m_smallRadius);
        for (Slot slot = 0; slot < m_small; ++slot)
            m_cells.insert(m_discs.data(), slot, placeOf(slot));
        if (!inOrder) {
            m_cells.all(m_discs.data(), m_near.data());
            sortDiscs();
        }
    }
    m_crossings = 0;
    findFirstEvents();
}

/// Puts the discs into the order of m_near, along the cycles of the permutation, so that it takes
/// no second array.
void ExactSolver::sortDiscs()
{
    m_moved.assign(m_small, false);
    for (std::size_t first = 0; first < m_small; ++first) {
        if (m_moved[first] || m_near[first] == first)
            continue;
        const Disc disc = m_discs[first];
        const std::uint32_t id = m_ids[first];
        const bool shaking = shakes(static_cast<Slot>(first));
        std::size_t slot = first;
        while (true) {
            m_moved[slot] = true;
            const std::size_t from = m_near[slot];
            const bool last = from == first;
            m_discs[slot] = last ? disc : m_discs[from];
            m_ids[slot] = last ? id : m_ids[from];
            if (m_lossy)
                m_shaking[slot] = last ? shaking : m_shaking[from];
            if (last)
                break;
            slot = from;
        }
    }
}

bool ExactSolver::isVoid(const Plan &plan) const
{
    return !isWall(plan.partner) && m_discs[plan.partner].hits != plan.partnerHits;
}

void ExactSolver::advance(double dt, double time, qint64 step, std::vector<Hit> &hits)
{
    aim(dt, time, step);
    while (!run(std::numeric_limits<std::size_t>::max(), hits)) {
    }
}

void ExactSolver::aim(double dt, double time, qint64 step)
{
    m_step = step;
    m_startTime = time - dt - m_now;
    m_now += dt;
}

bool ExactSolver::run(std::size_t events, std::vector<Hit> &hits)
{
    for (; m_queue.firstTime() <= m_now && !m_collapsed; --events) {
        if (events == 0)
            return false;
        takeNext(hits);
        // Carrying discs rounds, so when that happens must not depend on cells.
        if (m_hits >= hitsOfEpoch * (m_discs.size() + 1))
            beginEpoch();
        else if (m_crossings >= crossingsOfList * (m_discs.size() + 1))
            listDiscs();
    }
    if (m_collapsed && m_left == 0.0) {
        m_left = m_now - m_eventTime;
        m_now = m_eventTime;
    }
    return true;
}

/// Counts a contact that goes on. Windows begin with the first contact after the one before, so
/// they do not depend on steps.
void ExactSolver::noteLasting()
{
    const double time = m_elapsed + m_eventTime;
    if (time >= m_windowEnd) {
        m_windowEnd = time + window;
        m_lasting = 0;
    }
    ++m_lasting;
    m_collapsed = m_lasting > mostLasting;
}

void ExactSolver::takeNext(std::vector<Hit> &hits)
{
    const Slot a = m_queue.first();
    const Plan &plan = m_discs[a].plan;
    m_eventTime = m_queue.firstTime();
    // Those of a large crowd come from anywhere in memory.
    m_queue.visitSoonest([this](Slot slot) {
        const char *disc = reinterpret_cast<const char *>(&m_discs[slot]);
        __builtin_prefetch(disc);
        __builtin_prefetch(disc + 64);
    });
    if (plan.leave < plan.hit)
        cross(a);
    else if (isVoid(plan))
        findEvents(a);
    else
        takeHit(a, hits);
}

/// The hit that \p a plans, with whatever else happens at that moment.
void ExactSolver::takeHit(Slot a, std::vector<Hit> &hits)
{
    const Plan &plan = m_discs[a].plan;
    const Slot b = plan.partner;
    const double end = plan.hit + m_moment;
    const std::uint32_t held = m_discs[a].held | (isWall(b) ? 0 : m_discs[b].held);
    bool alone = held == 0 && plan.then > end;
    if (alone && m_queue.secondTime() <= end) {
        m_queue.set(a, infinity);
        // The partner may have foreseen the same hit.
        if (!isWall(b) && m_discs[b].plan.partner == a && m_discs[b].plan.then > end)
            m_queue.set(b, infinity);
        alone = m_queue.firstTime() > end;
    }
    if (!alone)
        takeMoment(a, b, hits);
    else if (isWall(b))
        hitWall(a, wallOf(b), hits);
    else
        hitPair(a, b, hits);
}

void ExactSolver::read(std::span<Circle> circles) const
{
    for (std::size_t slot = 0; slot < m_discs.size(); ++slot) {
        Disc disc = m_discs[slot];
        carryTo(disc, m_now);
        Circle &circle = circles[m_ids[slot]];
        circle.position = disc.position;
        circle.velocity = disc.velocity;
    }
}

} // namespace cradle
