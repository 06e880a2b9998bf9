// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous_step.h"

#include "model/collision_response.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cradle {

namespace {

/// Hits closer than this share of the step are one moment: rounding, not physics, parts them.
constexpr double simultaneous = 1e-12;
/// A gap below this share of the lengths concerned is touching: some roundings of a position.
constexpr double touching = 1e-9;
/// An elastic hit slower than this share of g Δt is no hit: it would repeat without end.
constexpr double stillElastic = 1e-9;
/// Closing speeds below this share of g Δt, and of the fastest speed there is, are rest: rounding
/// leaves as much where two should move alike.
constexpr double atRest = 1e-6;
constexpr double roundedSpeed = 1e-13;
/// Moments of impact in one step, per circle and in all, after which nothing rebounds, and after
/// twice as many the step ends where it is: a bound on the work, met only by inelastic collapse.
constexpr int momentsPerCircle = 50;
constexpr int momentsAtLeast = 500;

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

} // namespace

void ContinuousStep::run(const Rules &rules, World &world, double dt, std::vector<Hit> &hits)
{
    m_rules = &rules;
    m_world = &world;
    m_dt = dt;
    begin();
    const int enough = momentsAtLeast + momentsPerCircle * static_cast<int>(m_bodies.size());
    for (int moment = 0; moment < 2 * enough; ++moment) {
        findEvents();
        if (m_events.empty())
            break;
        m_plastic = moment > enough;
        m_now =
            std::min_element(m_events.begin(), m_events.end(), [](const auto &x, const auto &y) {
                return x.time < y.time;
            })->time;
        takeEventsAt(m_now);
        resolve(hits);
        findAccelerations();
    }
    // Circles with an event left over have met the bound on the work; they wait where they are.
    for (const Event &event : m_events) {
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
    m_plastic = false;
    m_events.clear();
    m_bodies.assign(m_world->circles.size(), Body{});
    m_inverseMasses.resize(m_bodies.size());
    double fastest = 0.0;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        fastest = std::max(fastest, length(m_world->circles[i].velocity));
        m_bodies[i].integrator = m_rules->integrators[i];
        // An exchange of normal parts is what equal masses do.
        const bool equal = m_rules->laws.circles == CircleLaw::SwapNormal;
        m_inverseMasses[i] = equal ? 1.0 : 1.0 / mass(m_world->circles[i]);
        m_bodies[i].touched = true;
    }
    m_slow = atRest * length(m_rules->gravity) * m_dt + roundedSpeed * fastest;
    findRestingPairs();
    findAccelerations();
}

void ContinuousStep::findRestingPairs()
{
    m_resting.clear();
    if (m_rules->laws.circles == CircleLaw::None)
        return;
    const auto &circles = m_world->circles;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        for (std::size_t j = i + 1; j < circles.size(); ++j) {
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
    if (std::find(m_resting.begin(), m_resting.end(), pair) == m_resting.end())
        m_resting.push_back(pair);
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
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        Body &body = m_bodies[i];
        if (!body.touched)
            continue;
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

Path ContinuousStep::pathFrom(std::size_t body, double time) const
{
    const Circle &c = m_world->circles[body];
    const Vec2 curve = pathCurvature(m_bodies[body].integrator) * m_bodies[body].acceleration;
    const Path path{c.position, c.velocity, curve};
    const double s = time - m_bodies[body].since;
    return {path.at(s), path.velocity + (2.0 * s) * curve, curve};
}

void ContinuousStep::findEvents()
{
    std::erase_if(m_events, [this](const Event &event) {
        return m_bodies[at(event.a)].touched || (!event.wall && m_bodies[at(event.b)].touched);
    });
    const bool walls = m_rules->laws.walls == WallLaw::Reflect;
    const bool circles = m_rules->laws.circles != CircleLaw::None;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (!m_bodies[i].touched)
            continue;
        for (const Wall wall : allWalls) {
            if (!walls || isHeld(i, wall))
                continue;
            const Vec2 n = outwardNormal(wall);
            const Path path = pathFrom(i, m_now);
            const double gap =
                m_rules->halfWidth - m_world->circles[i].radius - dot(path.position, n);
            if (const auto s =
                    timeToLine(gap, dot(path.velocity, n), dot(path.curve, n), m_dt - m_now))
                m_events.push_back({m_now + *s, static_cast<int>(i), static_cast<int>(wall), true});
        }
        for (std::size_t j = 0; circles && j < m_bodies.size(); ++j) {
            if (j > i || !m_bodies[j].touched)
                if (j != i)
                    findPairEvent(std::min(i, j), std::max(i, j));
        }
    }
    for (Body &body : m_bodies)
        body.touched = false;
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
    const bool resting = std::find(m_resting.begin(), m_resting.end(), pair) != m_resting.end();
    if (resting && std::abs(closingSpeed(contactOf(pair))) <= m_slow)
        return;
    if (const auto s = timeToDistance(a, b, distance, end))
        m_events.push_back({m_now + *s, pair.first, pair.second, false});
}

void ContinuousStep::carryTo(std::size_t body, double time)
{
    Circle &c = m_world->circles[body];
    const double s = time - m_bodies[body].since;
    if (s <= 0.0)
        return;
    const Motion m = advance(m_bodies[body].integrator, {c.position, c.velocity},
                             m_bodies[body].acceleration, s);
    c.position = m.position;
    c.velocity = m.velocity;
    m_bodies[body].since = time;
}

void ContinuousStep::takeEventsAt(double time)
{
    m_taken.clear();
    for (const Event &event : m_events) {
        if (event.time > time + simultaneous * m_dt)
            continue;
        m_taken.push_back(event);
        m_bodies[at(event.a)].touched = true;
        if (!event.wall)
            m_bodies[at(event.b)].touched = true;
    }
    std::sort(m_taken.begin(), m_taken.end(), [](const Event &x, const Event &y) {
        return std::tuple(x.wall, x.a, x.b) < std::tuple(y.wall, y.a, y.b);
    });
    touchRestingNeighbours();
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (m_bodies[i].touched)
            carryTo(i, time);
    }
}

/// What rests on a body that is hit is split at the hit, too: the forces between them change.
void ContinuousStep::touchRestingNeighbours()
{
    bool grown = true;
    while (grown) {
        grown = false;
        for (const auto &[a, b] : m_resting) {
            if (m_bodies[at(a)].touched != m_bodies[at(b)].touched) {
                m_bodies[at(a)].touched = m_bodies[at(b)].touched = true;
                grown = true;
            }
        }
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
    return m_plastic || (e < 1.0 ? 2.0 * e * closing <= gain : closing < stillElastic * gain);
}

void ContinuousStep::resolve(std::vector<Hit> &hits)
{
    m_contacts.clear();
    m_hits.clear();
    for (const Event &event : m_taken)
        meet(event);
    addSupports();

    const CircleLaw law = m_rules->laws.circles;
    if (law == CircleLaw::Stop || law == CircleLaw::SwapVelocities)
        respondInTurn();
    else
        respondTogether();

    for (std::size_t i = 0; i < m_hits.size(); ++i) {
        Hit &hit = m_hits[i];
        Circle &a = m_world->circles[at(hit.a)];
        const bool wall = hit.kind == Hit::Kind::Wall;
        hit.afterA = a.velocity;
        hit.afterB = wall ? Vec2{} : m_world->circles[at(hit.b)].velocity;
        hit.impulse = m_contacts[i].impulse;
        hit.loss = m_contacts[i].loss;
        if (dot(hit.beforeA - hit.beforeB, hit.normal) > m_slow)
            hits.push_back(hit);
    }
}

/// Where a contact comes to rest, what holds its circles takes part: else they would hand the
/// same push to and fro, each time a little less.
void ContinuousStep::addSupports()
{
    if (std::none_of(m_contacts.begin(), m_contacts.end(),
                     [](const Contact &contact) { return contact.rests; }))
        return;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        for (const Wall wall : allWalls) {
            if (m_bodies[i].touched && isHeld(i, wall))
                m_contacts.push_back({.a = static_cast<int>(i), .normal = outwardNormal(wall)});
        }
    }
    for (const auto &pair : m_resting) {
        const Contact contact = contactOf(pair);
        const bool met = std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &c) {
            return c.a == contact.a && c.b == contact.b;
        });
        if (m_bodies[at(pair.first)].touched && !met && std::abs(closingSpeed(contact)) <= m_slow)
            m_contacts.push_back(contact);
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
        // Rounding must not leave it a hair beyond the wall.
        const double beyond = dot(a.position, hit.normal) - (m_rules->halfWidth - a.radius);
        a.position -= beyond * hit.normal;
    } else {
        const Circle &b = m_world->circles[at(event.b)];
        hit.normal = normalized(b.position - a.position);
        hit.beforeB = b.velocity;
    }
    contact.normal = hit.normal;
    const double closing = std::max(0.0, closingSpeed(contact));
    contact.rests = closingSpeed(contact) >= -m_slow && comesToRest(contact, closing);
    contact.change = (contact.rests ? 1.0 : 1.0 + restitutionOf(contact)) * closing;
    m_bodies[at(event.a)].integrator = Integrator::Verlet;
    if (!event.wall)
        m_bodies[at(event.b)].integrator = Integrator::Verlet;
    if (contact.rests && !event.wall)
        rest({event.a, event.b});
    m_contacts.push_back(contact);
    m_hits.push_back(hit);
}

void ContinuousStep::respondTogether()
{
    solveContacts(m_contacts, m_inverseMasses);
    // Changes are summed before they are applied, so that mirrored contacts stay mirrored.
    m_changes.assign(m_bodies.size(), Vec2{});
    for (Contact &contact : m_contacts) {
        const double unit = m_inverseMasses[at(contact.a)];
        m_changes[at(contact.a)] -= (contact.impulse * unit) * contact.normal;
        if (contact.b >= 0)
            m_changes[at(contact.b)] +=
                (contact.impulse * m_inverseMasses[at(contact.b)]) * contact.normal;
    }
    // A change Δ out of the whole change of v to v' takes −½ m (v + v')·Δ of the energy.
    const auto loss = [this](int body, Vec2 change) {
        const Circle &c = m_world->circles[at(body)];
        return -0.5 * mass(c) * dot(2.0 * c.velocity + m_changes[at(body)], change);
    };
    for (Contact &contact : m_contacts) {
        const double unit = m_inverseMasses[at(contact.a)];
        contact.loss = loss(contact.a, -(contact.impulse * unit) * contact.normal);
        if (contact.b >= 0)
            contact.loss += loss(contact.b, (contact.impulse * m_inverseMasses[at(contact.b)])
                                                * contact.normal);
        contact.impulse *= unit * mass(m_world->circles[at(contact.a)]);
    }
    for (const Contact &contact : m_contacts) {
        for (const int body : {contact.a, contact.b}) {
            if (body >= 0)
                m_world->circles[at(body)].velocity += std::exchange(m_changes[at(body)], Vec2{});
        }
    }
}

void ContinuousStep::respondInTurn()
{
    for (Contact &contact : m_contacts) {
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
