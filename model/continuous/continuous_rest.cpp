// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include <algorithm>

namespace cradle {

// What rests on what, and the forces that hold it: the part of a step before its next hit.

namespace {

/// A gap below this share of the lengths concerned is touching: some roundings of a position.
constexpr double touching = 1e-9;
/// An overlap deeper than any that this timing leaves shrinks by this share in a step, and by no
/// more than so much of the radii.
constexpr double repaired = 0.1;
constexpr double mostRepaired = 1e-4;

} // namespace

void ContinuousStep::findRestingPairs()
{
    m_rest.pairs.clear();
    if (m_rules->laws.circles == CircleLaw::None)
        return;
    const auto &circles = m_world->circles;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        for (const std::uint32_t j : m_neighbours.of(i)) {
            if (j < i)
                continue;
            const Vec2 d = circles[j].position - circles[i].position;
            const double near = (circles[i].radius + circles[j].radius) * (1.0 + touching);
            if (lengthSquared(d) > near * near)
                continue;
            const std::pair<int, int> pair(static_cast<int>(i), static_cast<int>(j));
            if (std::abs(closingSpeed(contactOf(pair))) <= m_slow)
                rest(pair);
        }
    }
}

/// Notes that two stay in touch; they move alike from now on, whatever their integrators.
void ContinuousStep::rest(std::pair<int, int> pair)
{
    const auto place = std::lower_bound(m_rest.pairs.begin(), m_rest.pairs.end(), pair);
    if (place == m_rest.pairs.end() || *place != pair)
        m_rest.pairs.insert(place, pair);
    m_bodies[at(pair.first)].integrator = Integrator::Verlet;
    m_bodies[at(pair.second)].integrator = Integrator::Verlet;
}

bool ContinuousStep::isHeld(std::size_t body, Vec2 n) const
{
    const Circle &c = m_world->circles[body];
    const double gap = m_rules->halfWidth - c.radius - dot(c.position, n);
    return m_rules->laws.walls == WallLaw::Reflect && gap <= touching * c.radius
           && std::abs(dot(c.velocity, n)) <= m_slow
           && (dot(m_rules->gravity, n) > 0.0 || !m_rest.pairs.empty());
}

void ContinuousStep::findAccelerations()
{
    std::erase_if(m_rest.held, [this](const std::pair<int, int> &pair) {
        return m_bodies[at(pair.first)].touched || m_bodies[at(pair.second)].touched;
    });
    for (const std::size_t i : m_touched) {
        m_bodies[i].acceleration = m_rules->gravity;
        m_bodies[i].drifts = false;
    }
    m_rest.contacts.clear();
    if (m_dt - m_now <= 0.0)
        return;
    findPiles();
    addPairs();
    addWalls();
    hold();
}

/// Circles that lie on the floor, and on each other: who is slow beside one of them, and so near
/// that gravity could bring them together in a step, belongs to the pile.
void ContinuousStep::findPiles()
{
    if (!isLossy() || m_rules->gravity == Vec2{} || m_rules->laws.walls != WallLaw::Reflect)
        return;
    const double gain = length(m_rules->gravity) * m_dt; // what leaves faster is not of it
    m_rest.marks.assign(m_bodies.size(), 0);
    std::vector<std::size_t> open; // of the pile, still to be looked around
    for (const std::size_t i : m_touched) {
        for (const Wall wall : allWalls) {
            const Contact contact{.a = static_cast<int>(i), .normal = outwardNormal(wall)};
            if (dot(m_rules->gravity, contact.normal) <= 0.0 || !staysClose(contact)
                || closingSpeed(contact) < -gain)
                continue;
            open.push_back(i);
            m_rest.marks[i] = 1;
            break;
        }
    }
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        for (const std::uint32_t j : m_neighbours.of(i)) {
            const std::pair<int, int> pair = std::minmax(static_cast<int>(i), static_cast<int>(j));
            if (!m_bodies[j].touched || !staysClose(contactOf(pair))
                || closingSpeed(contactOf(pair)) < -gain)
                continue;
            rest(pair);
            if (m_rest.marks[j] == 0)
                open.push_back(j);
            m_rest.marks[j] = 1;
        }
    }
}

/// Adds the contacts of circles that lie on each other, with the fall of closing speed that they
/// need if nothing else held them: as far as their gap can be closed in the rest of the step.
void ContinuousStep::addPairs()
{
    for (const auto &pair : m_rest.pairs) {
        if (!m_bodies[at(pair.first)].touched)
            continue;
        Contact contact = contactOf(pair);
        const double closing = closingSpeed(contact);
        if (std::abs(closing) > m_slow && !staysClose(contact))
            continue;
        if (isLossy())
            contact.change = closing - freeSpeed(contact);
        m_rest.contacts.push_back(contact);
    }
}

/// Adds what the walls do to those circles; others they hold by themselves, exactly.
void ContinuousStep::addWalls()
{
    m_rest.marks.assign(m_bodies.size(), 0);
    for (const Contact &contact : m_rest.contacts)
        m_rest.marks[at(contact.a)] = m_rest.marks[at(contact.b)] = 1;
    const double end = m_dt - m_now;
    for (const std::size_t i : m_touched) {
        Circle &c = m_world->circles[i];
        for (const Wall wall : allWalls) {
            const Vec2 n = outwardNormal(wall);
            Contact contact{.a = static_cast<int>(i), .normal = n};
            const bool held = isHeld(i, n);
            // What a wall holds is held exactly, or rounding would let it go.
            if (held)
                c.velocity -= dot(c.velocity, n) * n;
            if (m_rest.marks[i] == 0) {
                if (held && dot(m_bodies[i].acceleration, n) > 0.0)
                    m_bodies[i].acceleration -= dot(m_bodies[i].acceleration, n) * n;
                continue;
            }
            if (m_rules->laws.walls != WallLaw::Reflect
                || !(held || (isLossy() && staysClose(contact))))
                continue;
            contact.change = end * dot(m_rules->gravity, n);
            if (isLossy())
                contact.change += closingSpeed(contact) - freeSpeed(contact);
            m_rest.contacts.push_back(contact);
        }
    }
}

/// Finds the impulses J of the contacts over the rest of the step. Where circles rebound without
/// loss they act as even forces; else those they act on drift.
void ContinuousStep::hold()
{
    const double end = m_dt - m_now;
    solveContacts(m_rest.contacts, m_inverseMasses);
    for (const Contact &contact : m_rest.contacts) {
        if (contact.impulse <= 0.0)
            continue;
        const Vec2 push = (contact.impulse / end) * contact.normal;
        Body &a = m_bodies[at(contact.a)];
        a.acceleration -= m_inverseMasses[at(contact.a)] * push;
        a.drifts = isLossy();
        if (contact.b < 0)
            continue;
        Body &b = m_bodies[at(contact.b)];
        b.acceleration += m_inverseMasses[at(contact.b)] * push;
        b.drifts = isLossy();
    }
    // Walls hold exactly what the contacts leave undone by rounding.
    for (const Contact &contact : m_rest.contacts) {
        Vec2 &a = m_bodies[at(contact.a)].acceleration;
        const Vec2 n = contact.normal;
        if (contact.b >= 0 || (!isLossy() && contact.impulse <= 0.0))
            continue;
        if (isLossy() && (contact.impulse <= 0.0 || !isHeld(at(contact.a), n))) {
            const double atEnd = closingSpeed(contact) + end * dot(a, n);
            a -= (std::max(0.0, atEnd - std::max(0.0, freeSpeed(contact))) / end) * n;
        } else {
            a -= dot(a, n) * n;
        }
    }
    spreadDrift();
    for (const std::size_t i : m_touched)
        m_bodies[i].drift = m_world->circles[i].velocity + end * m_bodies[i].acceleration;
    for (const Contact &contact : m_rest.contacts) {
        if (contact.b >= 0 && m_bodies[at(contact.a)].drifts)
            m_rest.held.emplace_back(contact.a, contact.b);
    }
    std::sort(m_rest.held.begin(), m_rest.held.end());
}

/// Beside one that drifts the others drift, too: that they cannot meet holds of even motions.
void ContinuousStep::spreadDrift()
{
    bool grown = isLossy();
    while (grown) {
        grown = false;
        for (const Contact &contact : m_rest.contacts) {
            if (contact.b < 0)
                continue;
            Body &a = m_bodies[at(contact.a)];
            Body &b = m_bodies[at(contact.b)];
            grown = grown || a.drifts != b.drifts;
            a.drifts = b.drifts = a.drifts || b.drifts;
        }
    }
}

/// How far a contact is from touching, m; negative where they overlap.
double ContinuousStep::gapOf(const Contact &contact) const
{
    const Circle &a = m_world->circles[at(contact.a)];
    if (contact.b < 0)
        return m_rules->halfWidth - a.radius - dot(a.position, contact.normal);
    const Circle &b = m_world->circles[at(contact.b)];
    return length(b.position - a.position) - a.radius - b.radius;
}

/// At which speed a contact may close until the step ends, m/s; where they overlap deeply it shall
/// part.
double ContinuousStep::freeSpeed(const Contact &contact) const
{
    const double gap = gapOf(contact);
    const double radius = m_world->circles[at(contact.a)].radius;
    if (-gap > deepOverlap * radius)
        return std::max(repaired * gap, -mostRepaired * radius) / m_dt;
    return std::max(0.0, gap) / (m_dt - m_now);
}

/// Whether two are so near, and close so slowly if at all, that, one of them held, gravity keeps
/// them together: a rebound would last less than a step.
bool ContinuousStep::staysClose(const Contact &contact) const
{
    const double closing = closingSpeed(contact);
    const double gain = length(m_rules->gravity) * m_dt; // m/s that a step gives at most
    const double along = std::abs(dot(m_rules->gravity, contact.normal)) * m_dt;
    return isLossy() && closing <= gain && 2.0 * m_rules->restitution * closing <= along
           && gapOf(contact) <= 2.0 * gain * (m_dt - m_now);
}

Contact ContinuousStep::contactOf(std::pair<int, int> pair) const
{
    const auto &circles = m_world->circles;
    return {.a = pair.first,
            .b = pair.second,
            .normal =
                normalized(circles[at(pair.second)].position - circles[at(pair.first)].position)};
}

double ContinuousStep::closingSpeed(const Contact &contact) const
{
    const Vec2 other = contact.b < 0 ? Vec2{} : m_world->circles[at(contact.b)].velocity;
    return dot(m_world->circles[at(contact.a)].velocity - other, contact.normal);
}

double ContinuousStep::closingAcceleration(const Contact &contact) const
{
    const Vec2 other = contact.b < 0 ? Vec2{} : m_bodies[at(contact.b)].acceleration;
    return dot(m_bodies[at(contact.a)].acceleration - other, contact.normal);
}

} // namespace cradle
