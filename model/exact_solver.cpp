// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far a disc may drift from its cell in an epoch, as a share of the mean spacing of the
/// discs: far enough that sorting is rare, near enough that few cells are searched.
constexpr double driftShare = 0.65;
/// Rounding of places and speeds parts hits of one moment by less than this many of their units.
constexpr double roundings = 64.0 * std::numeric_limits<double>::epsilon();
/// Without gravity: hits below this share of the speed that there was at the start lose nothing.
constexpr double quietShare = 1e-6;
/// A disc in a lasting contact looks ahead about as long as a fall by this many radii takes.
constexpr double searchHeight = 5e-3;

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
    m_ids.clear();
    m_discs.reserve(count);
    m_ids.reserve(count);
    const double bound = widestOfGrid(circles);
    m_smallRadius = 0.0;
    for (const bool giants : {false, true}) {
        for (std::size_t i = 0; i < count; ++i) {
            const Circle &c = circles[i];
            if ((c.radius > bound) != giants)
                continue;
            m_discs.push_back({.position = c.position,
                               .velocity = c.velocity,
                               .radius = c.radius,
                               .inverseMass = 1.0 / mass(c)});
            m_ids.push_back(static_cast<std::uint32_t>(i));
            if (!giants)
                m_smallRadius = std::max(m_smallRadius, c.radius);
        }
        if (!giants)
            m_small = m_discs.size();
    }
    setScales();
    m_shaking.assign(m_lossy ? count : 0, false);
    m_now = 0.0;
    m_epochEnd = 0.0;
    beginEpoch();
}

/// What is near and what is soon in this crowd.
void ExactSolver::setScales()
{
    Vec2 low{infinity, infinity};
    Vec2 high{-infinity, -infinity};
    Vec2 mean{};
    double squares = 0.0;
    double smallest = infinity;
    const auto count = static_cast<double>(std::max<std::size_t>(m_discs.size(), 1));
    for (const Disc &disc : m_discs) {
        low = {std::min(low.x, disc.position.x), std::min(low.y, disc.position.y)};
        high = {std::max(high.x, disc.position.x), std::max(high.y, disc.position.y)};
        mean += disc.velocity / count;
        squares += lengthSquared(disc.velocity) / count;
        smallest = std::min(smallest, disc.radius);
    }
    const double span = m_walls ? 2.0 * m_rules.halfWidth
                                : std::max({high.x - low.x, high.y - low.y, 0.0}) + m_smallRadius;
    const double spacing = span / std::sqrt(count);
    m_nextDrift = m_widestDrift = driftShare * spacing;
    const double speed = std::sqrt(std::max(0.0, squares - lengthSquared(mean)));
    m_quiet = quietShare * speed;
    m_lastingSearch = m_gravity > 0.0 ? std::sqrt(searchHeight * smallest / m_gravity) : infinity;
}

Vec2 ExactSolver::accelerationOf(const Disc &disc) const
{
    Vec2 a = m_rules.gravity;
    if (disc.held != 0) {
        for (const Wall wall : allWalls) {
            const Vec2 n = outwardNormal(wall);
            if ((disc.held & heldBy(wall)) != 0)
                a -= dot(a, n) * n;
        }
    }
    return a;
}

void ExactSolver::carryTo(Disc &disc, double time) const
{
    const double s = time - disc.clock;
    const Vec2 a = accelerationOf(disc);
    disc.position += s * (disc.velocity + (0.5 * s) * a);
    disc.velocity += s * a;
    disc.clock = time;
}

void ExactSolver::beginEpoch()
{
    double extent = m_rules.halfWidth;
    double fastest = 0.0;
    for (Disc &disc : m_discs) {
        carryTo(disc, m_epochEnd);
        disc.clock = 0.0;
        disc.hits = 0;
        extent = std::max({extent, std::abs(disc.position.x), std::abs(disc.position.y)});
        fastest = std::max(fastest, lengthSquared(disc.velocity));
    }
    m_now -= m_epochEnd;
    m_eventTime = 0.0;
    m_startTime += m_epochEnd;
    m_drift = m_nextDrift;
    m_events.clear();
    sortDiscs();

    m_foreseenAt = 0.0;
    m_foreseenDrift = 0.0;
    m_foreseenSpeed = 0.0;
    m_epochEnd = infinity;
    limitEpoch(std::sqrt(fastest));
    const double speed = m_foreseenSpeed + (m_gravity > 0.0 ? m_gravity * m_epochEnd : 0.0);
    m_moment = speed > 0.0 ? roundings * extent / speed : 0.0;
    findFirstEvents();
}

void ExactSolver::sortDiscs()
{
    m_grid.build(m_small, [this](std::size_t i) { return m_discs[i].position; });
    // Along the cycles of the permutation, so that it takes no second array.
    const std::span<const std::uint32_t> sorted = m_grid.sorted();
    m_moved.assign(m_small, false);
    for (std::size_t first = 0; first < m_small; ++first) {
        if (m_moved[first] || sorted[first] == first)
            continue;
        const Disc disc = m_discs[first];
        const std::uint32_t id = m_ids[first];
        const bool shaking = shakes(static_cast<Slot>(first));
        std::size_t slot = first;
        while (true) {
            m_moved[slot] = true;
            const std::size_t from = sorted[slot];
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

/// Takes note that a disc now has \p speed (m/s): the epoch ends before anything drifts too far.
void ExactSolver::limitEpoch(double speed)
{
    const double since = m_eventTime - m_foreseenAt;
    const double foreseen = m_foreseenSpeed + m_gravity * since;
    if (m_epochEnd < infinity && speed <= foreseen)
        return;
    m_foreseenDrift += since * (m_foreseenSpeed + 0.5 * m_gravity * since);
    m_foreseenSpeed = speed;
    m_foreseenAt = m_eventTime;
    const double left = std::max(0.0, m_drift - m_foreseenDrift);
    const double fastest = speed + std::sqrt(speed * speed + 2.0 * m_gravity * left);
    m_epochEnd =
        std::min(m_epochEnd, fastest > 0.0 ? m_eventTime + 2.0 * left / fastest : infinity);
}

bool ExactSolver::isVoid(const Event &event) const
{
    return m_discs[event.a].hits != event.hitsA
           || (isDisc(event.b) && m_discs[event.b].hits != event.hitsB);
}

void ExactSolver::advance(double dt, double time, qint64 step, std::vector<Hit> &hits)
{
    m_step = step;
    m_startTime = time - dt - m_now;
    m_now += dt;
    while (true) {
        if (!m_events.empty() && m_events.front().time <= std::min(m_now, m_epochEnd)) {
            takeNext(hits);
        } else if (m_epochEnd < m_now) {
            beginEpoch();
        } else {
            return;
        }
    }
}

void ExactSolver::takeNext(std::vector<Hit> &hits)
{
    const Event event = pop();
    if (isVoid(event))
        return;
    m_eventTime = event.time;
    if (event.b == lookAgain) {
        carryTo(m_discs[event.a], m_eventTime);
        findEvents(event.a);
        return;
    }
    if (!m_events.empty() && m_events.front().time <= event.time + m_moment)
        takeMoment(event, hits);
    else if (isWall(event.b))
        hitWall(event, hits);
    else
        hitPair(event, hits);
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
