// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cradle {

// Moments at which more than two discs, or a disc and what holds it, meet: their contacts are
// found and solved together, so that neither their order nor that of the circles matters.

namespace {

/// Places closer than this share of the lengths concerned are in touch.
constexpr double touching = 1e-12;

} // namespace

std::uint32_t ExactSolver::touch(Slot slot)
{
    if (m_place.size() < m_discs.size())
        m_place.resize(m_discs.size());
    const std::uint32_t place = m_place[slot];
    if (place < m_touched.size() && m_touched[place] == slot)
        return place;
    m_place[slot] = static_cast<std::uint32_t>(m_touched.size());
    m_touched.push_back(slot);
    carryTo(m_discs[slot], m_eventTime);
    return m_place[slot];
}

void ExactSolver::meet(Slot a, Slot b)
{
    touch(a);
    if (!isWall(b)) {
        touch(b);
        if (m_ids[b] < m_ids[a])
            std::swap(a, b);
    }
    m_meetings.push_back({a, b});
}

/// What happens at the moment at which \p a and \p b meet, be it no more than that.
void ExactSolver::takeMoment(Slot a, Slot b, std::vector<Hit> &hits)
{
    m_touched.clear();
    m_meetings.clear();
    m_contacts.clear();
    m_soft = true;
    const double end = m_eventTime + m_moment;
    meet(a, b);
    m_queue.set(a, infinity);
    while (m_queue.firstTime() <= end) {
        const Slot next = m_queue.first();
        const Plan &plan = m_discs[next].plan;
        if (plan.leave < plan.hit) {
            cross(next);
        } else if (isVoid(plan)) {
            findEvents(next);
        } else {
            meet(next, plan.partner);
            m_queue.set(next, infinity);
        }
    }
    // What touches these and closes, too, joins them; so does what touches those.
    for (std::size_t i = 0; i < m_touched.size(); ++i)
        joinNeighbours(m_touched[i]);

    const auto order = [this](const Meeting &m) {
        return std::tuple(isWall(m.b), m_ids[m.a], isWall(m.b) ? m.b : m_ids[m.b]);
    };
    std::sort(m_meetings.begin(), m_meetings.end(),
              [order](const Meeting &x, const Meeting &y) { return order(x) < order(y); });
    m_meetings.erase(std::unique(m_meetings.begin(), m_meetings.end()), m_meetings.end());

    if (m_meetings.size() == 1 && isWall(m_meetings[0].b)) {
        hitWall(m_meetings[0].a, wallOf(m_meetings[0].b), hits);
        return;
    }
    if (m_meetings.size() == 1) {
        hitPair(m_meetings[0].a, m_meetings[0].b, hits);
        return;
    }
    const CircleLaw law = m_rules.laws.circles;
    if (law == CircleLaw::Stop || law == CircleLaw::SwapVelocities)
        answerInTurn(hits);
    else
        answerTogether(hits);
    for (const Slot slot : m_touched) {
        noteHit(slot, m_soft);
        if (m_soft)
            noteLasting();
    }
    for (const Slot slot : m_touched)
        findEvents(slot);
}

void ExactSolver::joinNeighbours(Slot slot)
{
    const Disc &disc = m_discs[slot];
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        const double gap = m_rules.halfWidth - disc.radius - dot(disc.position, n);
        const double slow = roundedSpeed * length(disc.velocity);
        if ((disc.held & heldBy(wall)) != 0
            || (m_walls && gap <= touching * m_rules.halfWidth && dot(disc.velocity, n) > slow))
            meet(slot, wallSlot(wall));
    }
    if (!m_pairs)
        return;
    const std::size_t count = listGiants(listNear(slot));
    for (std::size_t i = 0; i < count; ++i) {
        const Slot other = m_near[i];
        if (other == slot)
            continue;
        Disc b = m_discs[other];
        carryTo(b, m_eventTime);
        const double sum = disc.radius + b.radius;
        const Vec2 d = b.position - disc.position;
        const double closing = dot(disc.velocity - b.velocity, d) / sum;
        const double near = sum * (1.0 + touching) + m_moment * std::max(closing, 0.0);
        if (lengthSquared(d) > near * near)
            continue;
        if (closing > roundedSpeed * (length(disc.velocity) + length(b.velocity)))
            meet(slot, other);
    }
}

Vec2 ExactSolver::normalOf(const Meeting &m) const
{
    if (isWall(m.b))
        return outwardNormal(wallOf(m.b));
    const Vec2 d = m_discs[m.b].position - m_discs[m.a].position;
    return d / std::sqrt(lengthSquared(d));
}

void ExactSolver::answerTogether(std::vector<Hit> &hits)
{
    m_contacts.clear();
    m_weights.clear();
    m_changes.assign(m_touched.size(), Vec2{});
    for (const Slot slot : m_touched)
        m_weights.push_back(weight(m_discs[slot]));
    const std::size_t firstHit = hits.size();
    for (const Meeting &m : m_meetings) {
        if (isWall(m.b))
            setAgainst(m_discs[m.a], wallOf(m.b));
        Contact contact{.a = static_cast<int>(m_place[m.a]),
                        .b = isWall(m.b) ? -1 : static_cast<int>(m_place[m.b]),
                        .normal = normalOf(m)};
        const double closing = std::max(0.0, closingSpeed(m.a, m.b, contact.normal));
        // A wall that holds a disc takes part, but asks for nothing.
        const bool support = isWall(m.b) && (m_discs[m.a].held & heldBy(wallOf(m.b))) != 0;
        const Rebound rebound =
            support ? Rebound{0.0, true, true} : reboundOf(m.a, m.b, contact.normal, closing);
        m_soft = m_soft && rebound.soft;
        contact.change = support ? 0.0 : closing + rebound.speed;
        contact.rests = rebound.lasting;
        m_contacts.push_back(contact);
        if (!rebound.lasting)
            hits.push_back(newHit(m.a, m.b, contact.normal));
    }
    solveContacts(m_contacts, m_weights);
    for (const Contact &c : m_contacts) {
        const auto a = static_cast<std::size_t>(c.a);
        m_changes[a] -= (c.impulse * m_weights[a]) * c.normal;
        if (c.b >= 0) {
            const auto b = static_cast<std::size_t>(c.b);
            m_changes[b] += (c.impulse * m_weights[b]) * c.normal;
        }
    }
    // A change Δ out of the whole change of v to v' takes −½ m (v + v')·Δ of the energy.
    const auto loss = [this](int body, Vec2 change) {
        const auto i = static_cast<std::size_t>(body);
        const Disc &disc = m_discs[m_touched[i]];
        return -0.5 / disc.inverseMass * dot(2.0 * disc.velocity + m_changes[i], change);
    };
    std::size_t hit = firstHit;
    for (const Contact &c : m_contacts) {
        if (c.rests)
            continue;
        const double wa = m_weights[static_cast<std::size_t>(c.a)];
        hits[hit].impulse =
            c.impulse * wa / m_discs[m_touched[static_cast<std::size_t>(c.a)]].inverseMass;
        hits[hit].loss = loss(c.a, -(c.impulse * wa) * c.normal);
        if (c.b >= 0)
            hits[hit].loss +=
                loss(c.b, (c.impulse * m_weights[static_cast<std::size_t>(c.b)]) * c.normal);
        ++hit;
    }
    for (std::size_t i = 0; i < m_touched.size(); ++i)
        m_discs[m_touched[i]].velocity += m_changes[i];
    settleOnWalls();
    hit = firstHit;
    for (std::size_t i = 0; i < m_meetings.size(); ++i) {
        if (m_contacts[i].rests)
            continue;
        hits[hit].afterA = m_discs[m_meetings[i].a].velocity;
        if (!isWall(m_meetings[i].b))
            hits[hit].afterB = m_discs[m_meetings[i].b].velocity;
        ++hit;
    }
}

/// What a wall holds is held exactly, or rounding would let it go; what leaves is free.
void ExactSolver::settleOnWalls()
{
    for (const Meeting &m : m_meetings) {
        if (!isWall(m.b))
            continue;
        Disc &disc = m_discs[m.a];
        const Vec2 n = outwardNormal(wallOf(m.b));
        const double outwards = dot(disc.velocity, n);
        const double before = dot(disc.velocity - m_changes[m_place[m.a]], n);
        const double slow = touching * (length(disc.velocity) + std::abs(before));
        if (outwards < -slow)
            disc.held &= ~heldBy(wallOf(m.b));
        else if (dot(m_rules.gravity, n) > 0.0) {
            disc.held |= heldBy(wallOf(m.b));
            disc.velocity -= outwards * n;
        }
    }
}

/// The laws that know no masses answer one contact after the other.
void ExactSolver::answerInTurn(std::vector<Hit> &hits)
{
    for (const Meeting &m : m_meetings) {
        const Vec2 n = normalOf(m);
        const double closing = closingSpeed(m.a, m.b, n);
        Disc &a = m_discs[m.a];
        Hit hit = newHit(m.a, m.b, n);
        if (isWall(m.b)) {
            setAgainst(a, wallOf(m.b));
            if ((a.held & heldBy(wallOf(m.b))) != 0 || closing <= 0.0)
                continue;
            const Rebound rebound = reboundOf(m.a, m.b, n, closing);
            m_soft = m_soft && rebound.soft;
            a.velocity -= (closing + rebound.speed) * n;
            if (rebound.speed == 0.0 && dot(m_rules.gravity, n) > 0.0)
                a.held |= heldBy(wallOf(m.b));
            hit.loss = 0.0;
        } else {
            Disc &b = m_discs[m.b];
            const Rebound rebound = reboundOf(m.a, m.b, n, std::max(0.0, closing));
            m_soft = m_soft && rebound.soft;
            if (closing <= 0.0 && !rebound.lasting)
                continue;
            respond(a, b, n, closing + rebound.speed, rebound.lasting);
            for (Disc *disc : {&a, &b})
                release(*disc);
            hit.afterB = b.velocity;
            hit.loss = kineticLoss(hit.beforeB, b);
        }
        hit.afterA = a.velocity;
        hit.loss += kineticLoss(hit.beforeA, a);
        hit.impulse = dot(hit.beforeA - hit.afterA, n) / a.inverseMass;
        hits.push_back(hit);
    }
}

/// Walls hold a disc no longer that flies away from them; it cannot fly into them.
void ExactSolver::release(Disc &disc)
{
    for (const Wall wall : allWalls) {
        const Vec2 n = outwardNormal(wall);
        if ((disc.held & heldBy(wall)) == 0)
            continue;
        const double outwards = dot(disc.velocity, n);
        if (outwards < 0.0)
            disc.held &= ~heldBy(wall);
        else
            disc.velocity -= outwards * n;
    }
}

} // namespace cradle
