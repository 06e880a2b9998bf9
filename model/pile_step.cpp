// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/pile_step.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Of the smallest radius: what is left between two that touch, so that the error of a push makes
/// them no overlap,
constexpr double apart = 1e-3;
/// and the error of a push in the end.
constexpr double exactness = 5e-5;
/// Of what gravity gives in a step: the error of a rebound.
constexpr double reboundTolerance = 0.01;
/// Of the same: a larger overlap shrinks, this share of it in a step.
constexpr double bearable = 5e-5;
constexpr double repaired = 0.1;
/// Sweeps over the contacts in a step, at most.
constexpr int mostSweeps = 120;
/// Then it is seen whether there are other contacts.
constexpr int firstSweeps = 16;
/// So often, at most, however few the sweeps.
constexpr int mostRounds = 40;
/// Sweeps that part what overlaps in the end.
constexpr int mostParting = 200;
/// A pile whose pushes throw circles farther than was foreseen looks around anew, so often.
constexpr int mostLooks = 4;

} // namespace

void PileStep::run(const Rules &rules, World &world, std::span<const std::uint32_t> ids, double dt,
                   std::vector<Hit> &hits)
{
    m_rules = &rules;
    m_world = &world;
    m_dt = dt;
    begin(ids);
    findNear();
    findMotion();
    fly();
    partEnds();
    rebound();
    boundEnergy();
    report(hits);
    keepPushes();
    for (Body i = 0; i < m_circles.size(); ++i) {
        Circle &c = world.circles[m_order[i]];
        c.position = m_ends[i];
        c.velocity = m_bodies.velocities[i];
    }
}

/// Sorts the bodies by height: as a grid does whose rows lie across gravity.
void PileStep::begin(std::span<const std::uint32_t> ids)
{
    const std::size_t count = m_world->circles.size();
    const double g = length(m_rules->gravity);
    const Vec2 up = g > 0.0 ? m_rules->gravity / -g : Vec2{0.0, 1.0};
    m_gain = g * m_dt;
    m_grid.build(count, [&](std::size_t i) {
        const Vec2 p = m_world->circles[i].position;
        return Vec2{cross(p, up), dot(p, up)};
    });
    const std::span<const std::uint32_t> sorted = m_grid.sorted();
    m_order.assign(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
    m_ids.clear();
    m_circles.clear();
    m_ways.clear();
    m_bodies.inverseMasses.clear();
    double least = std::numeric_limits<double>::infinity();
    double fastest = 0.0;
    for (const std::uint32_t i : m_order) {
        const Circle &c = m_world->circles[i];
        m_ids.push_back(ids[i]);
        m_circles.push_back(c);
        fastest = std::max(fastest, lengthSquared(c.velocity));
        m_bodies.inverseMasses.push_back(1.0 / mass(c));
        least = std::min(least, c.radius);
    }
    // A slow one may be kicked by a fast one.
    for (const Circle &c : m_circles)
        m_ways.push_back(m_dt
                         * (std::max(length(c.velocity), 0.5 * std::sqrt(fastest)) + 2.0 * m_gain));
    m_bodies.inverseMasses.resize(count + std::size(allWalls), 0.0);
    m_apart = apart * least;
}

/// Finds all pairs that can come together while no body leaves its way.
void PileStep::findNear()
{
    m_near.clear();
    double widest = 0.0;
    double farthest = 0.0;
    for (Body i = 0; i < m_circles.size(); ++i) {
        widest = std::max(widest, m_circles[i].radius);
        farthest = std::max(farthest, m_ways[i]);
    }
    const double g = length(m_rules->gravity);
    const Vec2 up = g > 0.0 ? m_rules->gravity / -g : Vec2{0.0, 1.0};
    for (Body i = 0; i < m_circles.size(); ++i) {
        const Circle &c = m_circles[i];
        const Vec2 place{cross(c.position, up), dot(c.position, up)};
        const double reach = c.radius + m_ways[i];
        m_grid.visitRunsAfter(i, place, reach + widest + farthest, [&](Body begin, Body end) {
            for (Body j = begin; j < end; ++j) {
                const double near = reach + m_circles[j].radius + m_ways[j];
                if (lengthSquared(m_circles[j].position - c.position) <= near * near)
                    addNear(i, j);
            }
        });
        if (m_rules->laws.walls != WallLaw::Reflect)
            continue;
        for (const Wall wall : allWalls) {
            if (dot(c.position, outwardNormal(wall)) + reach >= m_rules->halfWidth)
                addNear(i, static_cast<Body>(m_circles.size() + static_cast<Body>(wall)));
        }
    }
}

void PileStep::addNear(Body a, Body b)
{
    Near near{.a = a, .b = b};
    lookAt(near);
    m_near.push_back(near);
}

/// Finds when the two would meet if they flew straight on at what gravity makes of their speeds,
/// and along which normal. A plane across it that both keep to for the step keeps them apart.
void PileStep::lookAt(Near &near) const
{
    const Circle &a = m_circles[near.a];
    const Vec2 fall = m_dt * m_rules->gravity;
    if (isWall(near.b)) {
        near.normal = outwards(near.b);
        near.gap = m_rules->halfWidth - a.radius - dot(a.position, near.normal);
        const double closing = dot(a.velocity + fall, near.normal);
        near.met = near.gap <= m_apart ? 0.0 : closing > 0.0 ? near.gap / closing : -1.0;
        near.met = near.met <= m_dt ? near.met : -1.0;
        near.speed = dot(a.velocity, near.normal)
                     + std::max(near.met, 0.0) * dot(m_rules->gravity, near.normal);
        return;
    }
    const Circle &b = m_circles[near.b];
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const double distance = length(d);
    const double sum = a.radius + b.radius;
    near.normal = d / distance;
    near.gap = distance - sum;
    near.met = near.gap <= m_apart ? 0.0 : -1.0;
    const double approach = -dot(d, v);
    const double rest = distance * distance - sum * sum;
    const double discriminant = approach * approach - lengthSquared(v) * rest;
    if (near.met < 0.0 && approach > 0.0 && discriminant > 0.0) {
        const double time = rest / (approach + std::sqrt(discriminant));
        if (time <= m_dt) {
            near.met = time;
            near.normal = normalized(d + time * v);
            near.gap = dot(d, near.normal) - sum;
        }
    }
    near.speed = -dot(v, near.normal);
}

/// At which speed a contact may close in the step, m/s; where they overlap it shall part.
double PileStep::limitOf(double gap) const
{
    const double overlap = std::min(0.0, gap + bearable / apart * m_apart);
    return (std::max(0.0, gap - m_apart) + repaired * overlap) / m_dt;
}

std::uint64_t PileStep::keyOf(const Near &near) const
{
    const std::uint64_t a = m_ids[near.a];
    const std::uint64_t b =
        isWall(near.b) ? ~std::uint64_t{near.b - m_circles.size()} & 0xffffffffU : m_ids[near.b];
    return std::min(a, b) << 32U | std::max(a, b);
}

void PileStep::activate(Near &near)
{
    near.active = true;
    const auto known = m_pushes.find(keyOf(near));
    m_nearOf.push_back(static_cast<std::uint32_t>(&near - m_near.data()));
    m_contacts.push_back({near.a, near.b, near.normal, limitOf(near.gap),
                          known == m_pushes.end() ? 0.0 : known->second});
}

/// Finds w. Contacts are those that would meet; then those, too, that the pushes make meet.
void PileStep::findMotion()
{
    activateFirst(false);
    int looks = 1;
    int left = mostSweeps;
    int part = firstSweeps;
    for (int round = 0; round < mostRounds; ++round) {
        setFree();
        const int sweeps = solvePile(m_contacts, m_bodies, tolerance(), part);
        left -= sweeps;
        const bool ends = left <= 0 || sweeps < part;
        part = std::clamp(left, firstSweeps, 2 * part);
        if (looks < mostLooks && haveComeFar()) {
            ++looks;
            keepPushes();
            findNear();
            activateFirst(true);
        } else if (!activateMissed() && ends) {
            break;
        }
    }
    m_motion.assign(m_bodies.velocities.begin(),
                    m_bodies.velocities.begin() + static_cast<std::ptrdiff_t>(m_circles.size()));
}

/// An error of a closing speed that is as good as none, m/s.
double PileStep::tolerance() const
{
    return exactness / apart * m_apart / m_dt;
}

/// Sets the velocities as they are without any push.
void PileStep::setFree()
{
    m_bodies.velocities.assign(m_bodies.inverseMasses.size(), Vec2{});
    for (Body i = 0; i < m_circles.size(); ++i)
        m_bodies.velocities[i] = m_circles[i].velocity + m_dt * m_rules->gravity;
}

/// \param again  those that were contacts before the bodies were looked around once more, too
void PileStep::activateFirst(bool again)
{
    m_contacts.clear();
    m_nearOf.clear();
    for (Near &near : m_near) {
        if (near.met >= 0.0 || isSlow(near) || (again && m_pushes.contains(keyOf(near))))
            activate(near);
    }
}

/// Whether a body goes farther than whom it may meet was looked for; it will be now.
bool PileStep::haveComeFar()
{
    bool far = false;
    for (Body i = 0; i < m_circles.size(); ++i) {
        const double way = m_dt * length(m_bodies.velocities[i]);
        far = far || way > m_ways[i];
        m_ways[i] = std::max(m_ways[i], way);
    }
    return far;
}

/// Whether the two are so near and so slow that any push may make them meet.
bool PileStep::isSlow(const Near &near) const
{
    const double speed = isWall(near.b)
                             ? length(m_circles[near.a].velocity)
                             : length(m_circles[near.a].velocity - m_circles[near.b].velocity);
    return speed <= 4.0 * m_gain && near.gap <= 2.0 * m_gain * m_dt;
}

/// Takes in what would overlap at the end of the step. \return whether there was any
bool PileStep::activateMissed()
{
    bool found = false;
    for (Near &near : m_near) {
        if (near.active)
            continue;
        const double closing =
            dot(m_bodies.velocities[near.a] - m_bodies.velocities[near.b], near.normal);
        if (m_dt * closing <= near.gap)
            continue;
        // They may pass each other beside this normal.
        if (!isWall(near.b)) {
            const Vec2 d = m_circles[near.b].position - m_circles[near.a].position;
            const Vec2 v = m_bodies.velocities[near.b] - m_bodies.velocities[near.a];
            const double sum = m_circles[near.a].radius + m_circles[near.b].radius;
            const double nearest =
                lengthSquared(v) > 0.0 ? std::clamp(-dot(d, v) / lengthSquared(v), 0.0, m_dt) : 0.0;
            if (lengthSquared(d + nearest * v) >= sum * sum)
                continue;
        }
        activate(near);
        found = true;
    }
    return found;
}

double PileStep::gapOf(const Near &near, const std::vector<Vec2> &places) const
{
    const double radius = m_circles[near.a].radius;
    if (isWall(near.b))
        return m_rules->halfWidth - radius - dot(places[near.a], outwards(near.b));
    return length(places[near.b] - places[near.a]) - radius - m_circles[near.b].radius;
}

/// Moves the bodies. Those that nothing pushes fly as their integrators have it, if they then meet
/// nothing that moves otherwise.
void PileStep::fly()
{
    m_pushed.assign(m_circles.size() + std::size(allWalls), 0);
    for (const PileContact &c : m_contacts) {
        if (c.push > 0.0)
            m_pushed[c.a] = m_pushed[c.b] = 1;
    }
    m_ends.resize(m_circles.size());
    const auto move = [this](Body i) {
        const double curve = pathCurvature(m_rules->integrators[m_order[i]]);
        const Vec2 w = m_pushed[i] != 0 ? m_motion[i]
                                        : m_circles[i].velocity + (curve * m_dt) * m_rules->gravity;
        m_ends[i] = m_circles[i].position + m_dt * w;
    };
    for (Body i = 0; i < m_circles.size(); ++i)
        move(i);
    bool grown = true;
    while (grown) {
        grown = false;
        for (const Near &near : m_near) {
            const bool even = m_pushed[near.a] != 0 && (isWall(near.b) || m_pushed[near.b] != 0);
            if (even || gapOf(near, m_ends) >= 0.0)
                continue;
            for (const Body body : {near.a, near.b}) {
                if (!isWall(body) && m_pushed[body] == 0) {
                    m_pushed[body] = 1;
                    move(body);
                    grown = true;
                }
            }
        }
    }
}

/// What those that are pushed have gained of energy if they end at \p velocities, J; what the
/// others gain is their integrator's.
double PileStep::gained(std::span<const Vec2> velocities) const
{
    double sum = 0.0;
    for (Body i = 0; i < m_circles.size(); ++i) {
        if (m_pushed[i] == 0)
            continue;
        const Vec2 way = m_ends[i] - m_circles[i].position;
        sum += (0.5 * (lengthSquared(velocities[i]) - lengthSquared(m_circles[i].velocity))
                - dot(m_rules->gravity, way))
               / m_bodies.inverseMasses[i];
    }
    return sum;
}

/// Parts what overlaps at the end because its push was not found exactly, each by its mass, if the
/// step has taken as much energy as that lifts.
void PileStep::partEnds()
{
    const double borne = bearable / apart * m_apart;
    m_unparted = m_ends;
    bool any = false;
    bool found = true;
    for (int sweep = 0; sweep < mostParting && found; ++sweep) {
        found = false;
        for (const Near &near : m_near) {
            const double gap = gapOf(near, m_ends);
            if (gap >= -borne)
                continue;
            found = any = true;
            const Vec2 normal =
                isWall(near.b) ? near.normal : normalized(m_ends[near.b] - m_ends[near.a]);
            const double weightA = m_bodies.inverseMasses[near.a];
            const double weightB = m_bodies.inverseMasses[near.b];
            const Vec2 way = ((0.5 * borne - gap) / (weightA + weightB)) * normal;
            m_ends[near.a] -= weightA * way;
            m_pushed[near.a] = m_pushed[near.b] = 1;
            if (!isWall(near.b))
                m_ends[near.b] += weightB * way;
        }
    }
    if (any && gained(m_motion) > 0.0)
        m_ends.swap(m_unparted);
}

/// Velocities after the step where contacts throw back what they met.
void PileStep::rebound()
{
    m_rebounds.clear();
    m_contactOf.clear();
    m_impulses.clear();
    const double e = m_rules->restitution;
    bool any = false;
    for (std::size_t k = 0; k < m_contacts.size(); ++k) {
        const Near &near = m_near[m_nearOf[k]];
        PileContact c = m_contacts[k];
        const bool hit = c.push > 0.0 && 2.0 * e * near.speed > m_gain;
        any = any || hit;
        c.limit = hit ? -e * near.speed : 0.0;
        m_impulses.push_back(c.push);
        if (c.push <= 0.0 && gapOf(near, m_ends) > 2.0 * m_apart)
            continue;
        m_rebounds.push_back(c);
        m_contactOf.push_back(static_cast<std::uint32_t>(k));
    }
    if (!any) {
        m_rebounds.clear();
        return;
    }
    setFree();
    solvePile(m_rebounds, m_bodies, reboundTolerance * m_gain, mostSweeps / 2);
    for (std::size_t i = 0; i < m_rebounds.size(); ++i) {
        const PileContact &c = m_rebounds[i];
        m_impulses[m_contactOf[i]] = c.push;
        if (c.push > 0.0)
            m_pushed[c.a] = m_pushed[c.b] = 1;
    }
}

/// Takes the rebounds only as far as there is energy for them.
void PileStep::boundEnergy()
{
    if (m_rebounds.empty() || gained(m_bodies.velocities) <= 0.0)
        return;
    double linear = 0.0;
    double square = 0.0;
    for (Body i = 0; i < m_circles.size(); ++i) {
        const Vec2 more = m_bodies.velocities[i] - m_motion[i];
        linear += dot(m_motion[i], more) / m_bodies.inverseMasses[i];
        square += 0.5 * lengthSquared(more) / m_bodies.inverseMasses[i];
    }
    if (square == 0.0)
        return;
    const double spare = std::max(0.0, -gained(m_motion));
    const double share = std::clamp(
        (std::sqrt(linear * linear + 4.0 * square * spare) - linear) / (2.0 * square), 0.0, 1.0);
    for (Body i = 0; i < m_circles.size(); ++i)
        m_bodies.velocities[i] = m_motion[i] + share * (m_bodies.velocities[i] - m_motion[i]);
}

/// Tells of what was met faster than gravity alone brings two together.
void PileStep::report(std::vector<Hit> &hits) const
{
    const double e = std::max(m_rules->restitution, 0.5);
    for (std::size_t k = 0; k < m_contacts.size(); ++k) {
        const PileContact &c = m_contacts[k];
        const Near &near = m_near[m_nearOf[k]];
        if (c.push <= 0.0 || 2.0 * e * near.speed <= m_gain)
            continue;
        const bool wall = isWall(near.b);
        const bool swapped = !wall && m_order[near.b] < m_order[near.a];
        const Body a = swapped ? near.b : near.a;
        const Body b = swapped ? near.a : near.b;
        const Vec2 fall = near.met * m_rules->gravity;
        Hit hit{.time = m_world->time - m_dt + std::max(near.met, 0.0),
                .step = m_world->step,
                .kind = wall ? Hit::Kind::Wall : Hit::Kind::Circle,
                .a = static_cast<int>(m_order[a]),
                .b = wall ? static_cast<int>(near.b - m_circles.size())
                          : static_cast<int>(m_order[b]),
                .normal = swapped ? -near.normal : near.normal,
                .impulse = m_impulses[k],
                .beforeA = m_circles[a].velocity + fall,
                .afterA = m_bodies.velocities[a]};
        if (!wall) {
            hit.beforeB = m_circles[b].velocity + fall;
            hit.afterB = m_bodies.velocities[b];
        }
        const double after = dot(hit.afterA - hit.afterB, hit.normal);
        hit.loss = 0.5 * hit.impulse * (near.speed + after);
        hits.push_back(hit);
    }
}

void PileStep::keepPushes()
{
    m_pairs.clear();
    if (m_pushes.size() > 8 * m_contacts.size() + 1024)
        m_pushes.clear();
    for (std::size_t k = 0; k < m_contacts.size(); ++k) {
        const Near &near = m_near[m_nearOf[k]];
        m_pushes[keyOf(near)] = m_contacts[k].push;
        if (m_contacts[k].push > 0.0 && !isWall(near.b))
            m_pairs.emplace_back(static_cast<int>(m_order[near.a]),
                                 static_cast<int>(m_order[near.b]));
    }
}

} // namespace cradle
