// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_step.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// Where the circles of a pile end, and how fast.

namespace {

/// Of what gravity gives in a step: the error of a rebound.
constexpr double reboundTolerance = 0.01;
/// Sweeps over the contacts for it, at most.
constexpr int mostSweeps = 60;
/// What overlaps in the end is parted in so many sweeps over what lies closer than so many overlaps
/// that may be; then it is seen who else does, so often for each row that the circles would fill.
constexpr int sweepsPerLook = 8;
constexpr double tightness = 4.0;
constexpr double looksPerRow = 4.0;

} // namespace

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

/// Moves two apart, each by its mass, if they overlap at the end by more than may be. \return
/// whether they did
bool PileStep::part(const Near &near)
{
    const double gap = gapOf(near, m_ends);
    if (gap >= -m_borne)
        return false;
    const Vec2 normal = isWall(near.b) ? near.normal : normalized(m_ends[near.b] - m_ends[near.a]);
    const double weightA = m_bodies.inverseMasses[near.a];
    const double weightB = m_bodies.inverseMasses[near.b];
    const Vec2 way = ((0.5 * m_borne - gap) / (weightA + weightB)) * normal;
    m_ends[near.a] -= weightA * way;
    if (!isWall(near.b))
        m_ends[near.b] += weightB * way;
    m_pushed[near.a] = m_pushed[near.b] = 1;
    return true;
}

/// Parts what overlaps at the end because its push was not found exactly, as far as the step has
/// taken the energy for it.
void PileStep::partEnds()
{
    m_unparted = m_ends;
    bool any = false;
    std::vector<std::uint32_t> tight; // who overlaps, or may do so when those are parted
    const double rows = std::sqrt(static_cast<double>(m_circles.size()));
    for (int look = static_cast<int>(looksPerRow * rows); look >= 0; --look) {
        bool overlap = false;
        tight.clear();
        for (std::uint32_t k = 0; k < m_near.size(); ++k) {
            const double gap = gapOf(m_near[k], m_ends);
            overlap = overlap || gap < -m_borne;
            if (gap < tightness * m_borne)
                tight.push_back(k);
        }
        any = any || overlap;
        if (!overlap)
            break;
        // Up and down again, for what is lifted may now overlap with what lies on it.
        for (int sweep = 0; sweep < sweepsPerLook && overlap; ++sweep) {
            overlap = false;
            for (const std::uint32_t k : tight)
                overlap = part(m_near[k]) || overlap;
            std::reverse(tight.begin(), tight.end());
        }
    }
    if (!any)
        return;
    const double lifted = gained(m_motion);
    m_ends.swap(m_unparted);
    const double before = gained(m_motion);
    const double share = lifted <= 0.0 ? 1.0 : before < 0.0 ? before / (before - lifted) : 0.0;
    for (Body i = 0; i < m_circles.size(); ++i)
        m_ends[i] += share * (m_unparted[i] - m_ends[i]);
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
    solvePile(m_rebounds, m_bodies, reboundTolerance * m_gain, mostSweeps);
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

} // namespace cradle
