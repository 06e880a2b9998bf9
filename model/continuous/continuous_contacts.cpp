// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_step.h"

#include "model/contacts/collision_response.h"

#include <algorithm>
#include <utility>

namespace cradle {

// How the contacts of one moment answer.

namespace {

/// An elastic hit slower than this share of g Δt is no hit: it would repeat without end.
constexpr double stillElastic = 1e-9;
/// So many lossy hits in a row, each within this share of the radius of the one before, are
/// inelastic collapse: there would be no end of them, so they end as one without rebound.
/// Source: McNamara, Young: Inelastic collapse in a one-dimensional gas, 1992.
constexpr int collapse = 30;
constexpr double samePlace = 1e-4;
/// Of half the width of the square: how far the rounding of a time carries a circle into a wall.
constexpr double rounded = 1e-14;

} // namespace

double ContinuousStep::restitutionOf(const Contact &contact) const
{
    if (contact.b < 0 || m_rules->laws.circles == CircleLaw::Impulse)
        return m_rules->restitution;
    return m_rules->laws.circles == CircleLaw::Stop ? 0.0 : 1.0;
}

bool ContinuousStep::comesToRest(const Contact &contact, double closing) const
{
    const double e = restitutionOf(contact);
    const double gain = closingAcceleration(contact) * m_dt; // m/s that a step gives back
    return e < 1.0 ? 2.0 * e * closing <= gain : closing < stillElastic * gain;
}

/// Counts the hit of a contact for its bodies. \return whether they hit without end
bool ContinuousStep::isCollapse(const Contact &contact)
{
    if (restitutionOf(contact) >= 1.0)
        return false;
    bool found = false;
    for (const int body : {contact.a, contact.b}) {
        if (body < 0)
            continue;
        Body &b = m_bodies[at(body)];
        const Circle &c = m_world->circles[at(body)];
        const bool same = length(c.position - b.latestHit) <= samePlace * c.radius;
        b.nearHits = same ? b.nearHits + 1 : 0;
        b.latestHit = c.position;
        found = found || b.nearHits >= collapse;
    }
    return found;
}

void ContinuousStep::resolve(std::vector<Hit> &hits)
{
    m_moment.contacts.clear();
    m_moment.hits.clear();
    for (const Event &event : m_moment.events)
        meet(event);
    addSupports();

    const CircleLaw law = m_rules->laws.circles;
    if (law == CircleLaw::Stop || law == CircleLaw::SwapVelocities)
        respondInTurn();
    else
        respondTogether();

    for (std::size_t i = 0; i < m_moment.hits.size(); ++i) {
        Hit &hit = m_moment.hits[i];
        Circle &a = m_world->circles[at(hit.a)];
        const bool wall = hit.kind == Hit::Kind::Wall;
        hit.afterA = a.velocity;
        hit.afterB = wall ? Vec2{} : m_world->circles[at(hit.b)].velocity;
        hit.impulse = m_moment.contacts[i].impulse;
        hit.loss = m_moment.contacts[i].loss;
        if (dot(hit.beforeA - hit.beforeB, hit.normal) > m_slow)
            hits.push_back(hit);
    }
}

/// Where a contact comes to rest, what holds its circles takes part: else they would hand the
/// same push to and fro, each time a little less.
void ContinuousStep::addSupports()
{
    if (std::none_of(m_moment.contacts.begin(), m_moment.contacts.end(),
                     [](const Contact &contact) { return contact.rests; }))
        return;
    for (const std::size_t i : m_touched) {
        for (const Wall wall : allWalls) {
            if (isHeld(i, outwardNormal(wall)))
                m_moment.contacts.push_back(
                    {.a = static_cast<int>(i), .normal = outwardNormal(wall)});
        }
    }
    for (const auto &pair : m_rest.pairs) {
        const Contact contact = contactOf(pair);
        const bool met =
            std::any_of(m_moment.contacts.begin(), m_moment.contacts.end(),
                        [&](const Contact &c) { return c.a == contact.a && c.b == contact.b; });
        if (m_bodies[at(pair.first)].touched && !met && std::abs(closingSpeed(contact)) <= m_slow)
            m_moment.contacts.push_back(contact);
    }
}

/// Makes a contact of an event, with the change of velocity that its law asks for.
void ContinuousStep::meet(const Event &event)
{
    Circle &a = m_world->circles[at(event.a)];
    Hit hit{.time = m_world->time - m_dt + m_now,
            .step = m_world->step,
            .kind = event.wall ? Hit::Kind::Wall : Hit::Kind::Circle,
            .a = event.a,
            .b = event.b,
            .beforeA = a.velocity};
    Contact contact{.a = event.a, .b = event.wall ? -1 : event.b};
    if (event.wall) {
        hit.normal = outwardNormal(static_cast<Wall>(event.b));
        // Rounding must not leave it a hair beyond the wall. What a pile has left there stays: it
        // has not the energy to be lifted.
        const double beyond = dot(a.position, hit.normal) - (m_rules->halfWidth - a.radius);
        if (beyond <= rounded * m_rules->halfWidth || beyond > deepOverlap * a.radius)
            a.position -= beyond * hit.normal;
    } else {
        const Circle &b = m_world->circles[at(event.b)];
        hit.normal = normalized(b.position - a.position);
        hit.beforeB = b.velocity;
    }
    contact.normal = hit.normal;
    const double closing = std::max(0.0, closingSpeed(contact));
    const bool endless = isCollapse(contact);
    contact.rests = closingSpeed(contact) >= -m_slow && (endless || comesToRest(contact, closing));
    contact.change = (contact.rests ? 1.0 : 1.0 + restitutionOf(contact)) * closing;
    m_bodies[at(event.a)].integrator = Integrator::Verlet;
    if (!event.wall)
        m_bodies[at(event.b)].integrator = Integrator::Verlet;
    // Two that drifted into each other must not do so again at once.
    const bool drifted = !event.wall && m_bodies[at(event.a)].drifts;
    if (!event.wall && (contact.rests || drifted || m_bodies[at(event.b)].drifts))
        rest({event.a, event.b});
    m_moment.contacts.push_back(contact);
    m_moment.hits.push_back(hit);
}

void ContinuousStep::respondTogether()
{
    solveContacts(m_moment.contacts, m_inverseMasses);
    // Changes are summed before they are applied, so that mirrored contacts stay mirrored.
    for (Contact &contact : m_moment.contacts) {
        const double unit = m_inverseMasses[at(contact.a)];
        m_moment.changes[at(contact.a)] -= (contact.impulse * unit) * contact.normal;
        if (contact.b >= 0)
            m_moment.changes[at(contact.b)] +=
                (contact.impulse * m_inverseMasses[at(contact.b)]) * contact.normal;
    }
    // A change Δ out of the whole change of v to v' takes −½ m (v + v')·Δ of the energy.
    const auto loss = [this](int body, Vec2 change) {
        const Circle &c = m_world->circles[at(body)];
        return -0.5 * mass(c) * dot(2.0 * c.velocity + m_moment.changes[at(body)], change);
    };
    for (Contact &contact : m_moment.contacts) {
        const double unit = m_inverseMasses[at(contact.a)];
        contact.loss = loss(contact.a, -(contact.impulse * unit) * contact.normal);
        if (contact.b >= 0)
            contact.loss += loss(contact.b, (contact.impulse * m_inverseMasses[at(contact.b)])
                                                * contact.normal);
        contact.impulse *= unit * mass(m_world->circles[at(contact.a)]);
    }
    for (const Contact &contact : m_moment.contacts) {
        for (const int body : {contact.a, contact.b}) {
            if (body >= 0)
                m_world->circles[at(body)].velocity +=
                    std::exchange(m_moment.changes[at(body)], Vec2{});
        }
    }
}

void ContinuousStep::respondInTurn()
{
    for (Contact &contact : m_moment.contacts) {
        Circle &a = m_world->circles[at(contact.a)];
        const Circle before = a;
        if (contact.b < 0) {
            reflect(a.velocity, contact.normal, contact.rests ? 0.0 : m_rules->restitution);
        } else {
            Circle &b = m_world->circles[at(contact.b)];
            const Circle beforeB = b;
            respond(m_rules->laws.circles, a, b, contact.normal, m_rules->restitution);
            contact.loss = kineticEnergy(beforeB) - kineticEnergy(b);
        }
        contact.loss += kineticEnergy(before) - kineticEnergy(a);
        contact.impulse = mass(a) * dot(before.velocity - a.velocity, contact.normal);
    }
}

} // namespace cradle
