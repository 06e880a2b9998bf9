// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous_step.h"

#include <algorithm>

namespace cradle {

// What rests on what, and the forces that hold it: the part of a step before its next hit.

namespace {

/// A gap below this share of the lengths concerned is touching: some roundings of a position.
constexpr double touching = 1e-9;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

} // namespace

void ContinuousStep::findRestingPairs()
{
    m_resting.clear();
    if (m_rules->laws.circles == CircleLaw::None)
        return;
    const auto &circles = m_world->circles;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        for (const std::uint32_t j : neighboursOf(i)) {
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
    const auto place = std::lower_bound(m_resting.begin(), m_resting.end(), pair);
    if (place == m_resting.end() || *place != pair)
        m_resting.insert(place, pair);
    m_bodies[at(pair.first)].integrator = Integrator::Verlet;
    m_bodies[at(pair.second)].integrator = Integrator::Verlet;
}

bool ContinuousStep::isHeld(std::size_t body, Wall wall) const
{
    const Circle &c = m_world->circles[body];
    const Vec2 n = outwardNormal(wall);
    const double gap = m_rules->halfWidth - c.radius - dot(c.position, n);
    return m_rules->laws.walls == WallLaw::Reflect && gap <= touching * c.radius
           && std::abs(dot(c.velocity, n)) <= m_slow
           && (dot(m_rules->gravity, n) > 0.0 || !m_resting.empty());
}

void ContinuousStep::findAccelerations()
{
    m_contacts.clear();
    for (const std::size_t i : m_touched) {
        Body &body = m_bodies[i];
        body.acceleration = m_rules->gravity;
        for (const Wall wall : allWalls) {
            if (!isHeld(i, wall))
                continue;
            const Vec2 n = outwardNormal(wall);
            // What a wall holds is held exactly, or rounding would let it go.
            Vec2 &velocity = m_world->circles[i].velocity;
            velocity -= dot(velocity, n) * n;
            if (m_resting.empty())
                body.acceleration -= dot(body.acceleration, n) * n;
            else
                m_contacts.push_back({.a = static_cast<int>(i), .normal = n});
        }
    }
    if (m_resting.empty())
        return;
    for (const auto &pair : m_resting) {
        const Contact contact = contactOf(pair);
        if (m_bodies[at(pair.first)].touched && std::abs(closingSpeed(contact)) <= m_slow)
            m_contacts.push_back(contact);
    }
    for (Contact &contact : m_contacts)
        contact.change = contact.b < 0 ? dot(m_rules->gravity, contact.normal) : 0.0;
    solveContacts(m_contacts, m_inverseMasses);
    for (const Contact &contact : m_contacts) {
        m_bodies[at(contact.a)].acceleration -=
            (contact.impulse * m_inverseMasses[at(contact.a)]) * contact.normal;
        if (contact.b >= 0)
            m_bodies[at(contact.b)].acceleration +=
                (contact.impulse * m_inverseMasses[at(contact.b)]) * contact.normal;
    }
    for (const Contact &contact : m_contacts) {
        Vec2 &a = m_bodies[at(contact.a)].acceleration;
        if (contact.b < 0 && contact.impulse > 0.0)
            a -= dot(a, contact.normal) * contact.normal;
    }
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
