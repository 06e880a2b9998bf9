// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include <algorithm>
#include <tuple>

namespace cradle {

namespace {

/// Hits closer than this share of the step are one moment: roundedTime, not physics, parts them.
constexpr double simultaneous = 1e-12;
/// Closing speeds below this share of g Δt, and of the fastest speed there is, are rest:
/// roundedTime leaves as much where two should move alike.
constexpr double atRest = 1e-6;
constexpr double roundedRebound = 1e-13;
/// Circles split by moments of impact in one step, per circle and in all, after which the step
/// ends where it is: a bound on the work, met only by laws that are not physics.
constexpr std::size_t splitsPerCircle = 1000;
constexpr std::size_t splitsAtLeast = 100'000;
constexpr double roundedTime = 1e-9;

/// The order of the heap of events.
constexpr auto later = [](const auto &x, const auto &y) { return x.time > y.time; };

} // namespace

void ContinuousStep::run(const Rules &rules, World &world, double dt, std::vector<Hit> &hits)
{
    m_rules = &rules;
    m_world = &world;
    m_dt = dt;
    // Find who can meet whom in the step, what rests on what, and the forces that hold it.
    begin();
    const std::size_t enough = splitsAtLeast + splitsPerCircle * m_bodies.size();
    for (std::size_t splits = 0; splits < enough; splits += m_touched.size()) {
        // Find anew when those meet that were touched by the latest moment.
        findEvents();
        // Carry to the next moment who meets then, and who rests on these.
        if (!nextMoment())
            break;
        // Answer all contacts of the moment together.
        resolve(hits);
        // Find whom the kicked may now meet, and what holds those that rest now.
        foreseeSpeeds();
        findAccelerations();
    }
    // Circles with an event left over have met the bound on the work; they wait where they are.
    for (const Event &event : m_events) {
        if (!isValid(event))
            continue;
        m_bodies[at(event.a)].since = dt;
        if (!event.wall)
            m_bodies[at(event.b)].since = dt;
    }
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
        carryTo(i, dt);
}

void ContinuousStep::begin()
{
    m_now = 0.0;
    m_events.clear();
    m_rest.held.clear();
    m_touched.clear();
    m_bodies.assign(m_world->circles.size(), Body{});
    m_inverseMasses.resize(m_bodies.size());
    m_moment.changes.assign(m_bodies.size(), Vec2{});
    double fastest = 0.0;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        fastest = std::max(fastest, lengthSquared(m_world->circles[i].velocity));
        m_bodies[i].integrator = m_rules->integrators[i];
        // An exchange of normal parts is what equal masses do.
        const bool equal = m_rules->laws.circles == CircleLaw::SwapNormal;
        m_inverseMasses[i] = equal ? 1.0 : 1.0 / mass(m_world->circles[i]);
    }
    touchAll();
    fastest = std::sqrt(fastest);
    m_slow = atRest * length(m_rules->gravity) * m_dt + roundedRebound * fastest;
    m_neighbours.find(m_world->circles, length(m_rules->gravity), m_dt);
    findRestingPairs();
    findAccelerations();
}

/// Looks again for neighbours if a body has become faster than was foreseen.
void ContinuousStep::foreseeSpeeds()
{
    double fastest = 0.0;
    for (const std::size_t i : m_touched)
        fastest = std::max(fastest, lengthSquared(m_world->circles[i].velocity));
    if (m_neighbours.foresee(std::sqrt(fastest)))
        touchAll();
}

/// What rests on a body that is hit is split at the hit, too: the forces between them change.
void ContinuousStep::touchRestingNeighbours()
{
    bool grown = true;
    while (grown) {
        grown = false;
        for (const auto &[a, b] : m_rest.pairs) {
            if (m_bodies[at(a)].touched != m_bodies[at(b)].touched) {
                touch(at(a));
                touch(at(b));
                grown = true;
            }
        }
    }
}

/// Notes that the events of a body must be found again.
void ContinuousStep::touch(std::size_t body)
{
    if (m_bodies[body].touched)
        return;
    m_bodies[body].touched = true;
    ++m_bodies[body].version;
    m_touched.push_back(body);
}

void ContinuousStep::touchAll()
{
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
        touch(i);
}

Path ContinuousStep::pathFrom(std::size_t body, double time) const
{
    const Circle &c = m_world->circles[body];
    const double s = time - m_bodies[body].since;
    if (m_bodies[body].drifts)
        return {c.position + s * m_bodies[body].drift, m_bodies[body].drift, Vec2{}};
    const Vec2 curve = pathCurvature(m_bodies[body].integrator) * m_bodies[body].acceleration;
    const Path path{c.position, c.velocity, curve};
    return {path.at(s), path.velocity + (2.0 * s) * curve, curve};
}

void ContinuousStep::push(const Event &event)
{
    m_events.push_back(event);
    std::push_heap(m_events.begin(), m_events.end(), later);
}

bool ContinuousStep::isValid(const Event &event) const
{
    return m_bodies[at(event.a)].version == event.versionA
           && (event.wall || m_bodies[at(event.b)].version == event.versionB);
}

/// Goes to the next moment at which something meets. \return false if nothing does
bool ContinuousStep::nextMoment()
{
    while (!m_events.empty() && !isValid(m_events.front())) {
        std::pop_heap(m_events.begin(), m_events.end(), later);
        m_events.pop_back();
    }
    if (m_events.empty())
        return false;
    m_now = m_events.front().time;
    takeEventsAt(m_now);
    return true;
}

void ContinuousStep::findEvents()
{
    for (const std::size_t i : m_touched) {
        if (m_rules->laws.walls == WallLaw::Reflect)
            findWallEvents(i);
        if (m_rules->laws.circles == CircleLaw::None)
            continue;
        for (const std::uint32_t j : m_neighbours.of(i)) {
            if (j > i || !m_bodies[j].touched)
                findPairEvent(std::min<std::size_t>(i, j), std::max<std::size_t>(i, j));
        }
    }
    for (const std::size_t i : m_touched)
        m_bodies[i].touched = false;
    m_touched.clear();
}

void ContinuousStep::findWallEvents(std::size_t i)
{
    const Path path = pathFrom(i, m_now);
    const double end = m_dt - m_now;
    const double reach = end
                         * (std::abs(path.velocity.x) + std::abs(path.velocity.y)
                            + end * (std::abs(path.curve.x) + std::abs(path.curve.y)));
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        const double radius = m_world->circles[i].radius;
        const double gap = m_rules->halfWidth - radius - dot(path.position, n);
        if (gap > reach + m_rules->halfWidth * roundedTime || isHeld(i, n))
            continue;
        const double speed = dot(path.velocity, n);
        // What is held ends at the wall, but for roundedTime.
        if (m_bodies[i].drifts && std::max(0.0, gap) - end * speed >= -roundedTime * radius)
            continue;
        if (const auto s = timeToLine(gap, speed, dot(path.curve, n), end))
            push({m_now + *s, static_cast<int>(i), static_cast<int>(wall), true,
                  m_bodies[i].version, 0});
    }
}

void ContinuousStep::findPairEvent(std::size_t i, std::size_t j)
{
    const double distance = m_world->circles[i].radius + m_world->circles[j].radius;
    const double end = m_dt - m_now;
    const Path a = pathFrom(i, m_now);
    const Path b = pathFrom(j, m_now);
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const Vec2 k = b.curve - a.curve;
    // Too far apart to meet within the step, whatever the direction.
    if (std::abs(d.x) > distance + end * (std::abs(v.x) + end * std::abs(k.x))
        || std::abs(d.y) > distance + end * (std::abs(v.y) + end * std::abs(k.y)))
        return;
    const std::pair<int, int> pair(static_cast<int>(i), static_cast<int>(j));
    if (std::binary_search(m_rest.held.begin(), m_rest.held.end(), pair))
        return;
    const bool resting = std::binary_search(m_rest.pairs.begin(), m_rest.pairs.end(), pair);
    if (resting && std::abs(closingSpeed(contactOf(pair))) <= m_slow)
        return;
    if (const auto s = timeToDistance(a, b, distance, end))
        push(
            {m_now + *s, pair.first, pair.second, false, m_bodies[i].version, m_bodies[j].version});
}

void ContinuousStep::carryTo(std::size_t body, double time)
{
    Circle &c = m_world->circles[body];
    const double s = time - m_bodies[body].since;
    if (s <= 0.0)
        return;
    if (m_bodies[body].drifts) {
        c.position += s * m_bodies[body].drift;
        c.velocity += s * m_bodies[body].acceleration;
        m_bodies[body].since = time;
        return;
    }
    const Motion m = advance(m_bodies[body].integrator, {c.position, c.velocity},
                             m_bodies[body].acceleration, s);
    c.position = m.position;
    c.velocity = m.velocity;
    m_bodies[body].since = time;
}

void ContinuousStep::takeEventsAt(double time)
{
    m_moment.events.clear();
    while (!m_events.empty() && m_events.front().time <= time + simultaneous * m_dt) {
        std::pop_heap(m_events.begin(), m_events.end(), later);
        if (isValid(m_events.back()))
            m_moment.events.push_back(m_events.back());
        m_events.pop_back();
    }
    for (const Event &event : m_moment.events) {
        touch(at(event.a));
        if (!event.wall)
            touch(at(event.b));
    }
    std::sort(m_moment.events.begin(), m_moment.events.end(), [](const Event &x, const Event &y) {
        return std::tuple(x.wall, x.a, x.b) < std::tuple(y.wall, y.a, y.b);
    });
    touchRestingNeighbours();
    // In the order of the bodies, so that sums do not depend on that of the events.
    std::sort(m_touched.begin(), m_touched.end());
    for (const std::size_t i : m_touched)
        carryTo(i, time);
}

} // namespace cradle
