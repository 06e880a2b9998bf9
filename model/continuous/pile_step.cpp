// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_step.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Of the smallest radius: what is left between two that touch, so that the error of a push makes
/// them no overlap,
constexpr double apart = 1e-3;
/// and the error of a push in the end.
constexpr double exactness = 5e-5;
/// Of the same: a larger overlap shrinks, this share of it in a step.
constexpr double bearable = 5e-5;
constexpr double repaired = 0.1;
/// Sweeps over the contacts in a step, at most; of heaps higher than those of 1,000 circles so many
/// more for each row that as many alike would fill a square with.
constexpr int mostSweeps = 120;
constexpr double sweepsPerRow = 10.0;
constexpr double fewRows = 32.0;
/// Then it is seen whether there are other contacts.
constexpr int firstSweeps = 16;
/// So often, at most, however few the sweeps.
constexpr int mostRounds = 40;
/// A pile whose pushes throw circles farther than was foreseen looks around anew, so often.
constexpr int mostLooks = 4;

} // namespace

void PileStep::run(const Rules &rules, World &world, std::span<const std::uint32_t> ids, double dt,
                   std::vector<Hit> &hits)
{
    m_rules = &rules;
    m_world = &world;
    m_dt = dt;
    // Sort the circles by height, and find who may meet whom.
    begin(ids);
    findNear();
    // Motion: the pushes at which no contact closes faster than its gap allows.
    findMotion();
    // Move the circles, and part what still overlaps.
    fly();
    partEnds();
    // Rebound: the velocities at which what was met parts, as far as there is energy for it.
    rebound();
    boundEnergy();
    // Tell of the hits, and begin with these pushes in the next step.
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
        m_ways.push_back(
            m_dt * (std::max(quickLength(c.velocity), 0.5 * std::sqrt(fastest)) + 2.0 * m_gain));
    m_bodies.inverseMasses.resize(count + std::size(allWalls), 0.0);
    m_apart = apart * least;
    m_borne = bearable * least;
    m_tolerance = exactness * least / m_dt;
}

/// At which speed a contact may close in the step, m/s; where they overlap it shall part.
double PileStep::limitOf(double gap) const
{
    const double overlap = std::min(0.0, gap + m_borne);
    return (std::max(0.0, gap - m_apart) + repaired * overlap) / m_dt;
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
    const double rows = std::sqrt(static_cast<double>(m_circles.size()));
    int left = mostSweeps + static_cast<int>(sweepsPerRow * std::max(0.0, rows - fewRows));
    int part = firstSweeps;
    for (int round = 0; round < mostRounds; ++round) {
        setFree();
        const int sweeps = solvePile(m_contacts, m_bodies, m_tolerance, part);
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
