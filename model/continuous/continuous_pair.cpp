// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// Two circles that meet once in a step, far from walls: what nearly every hit of a gas is. The same
// as ContinuousStep would do, without looking for anything else.

/// \return false if it is not that simple; then nothing was done
bool ContinuousSolver::solvePair(std::uint32_t member, std::uint32_t other, std::uint32_t run)
{
    Member &first = m_groups[member];
    Member &second = m_groups[other];
    const CircleLaw law = m_rules.laws.circles;
    const double e = law == CircleLaw::Impulse ? m_rules.restitution : 1.0;
    if ((law != CircleLaw::Impulse && law != CircleLaw::SwapNormal) || e == 0.0)
        return false;
    const Slot a = first.slot;
    const Slot b = second.slot;
    const auto s = timeToDistance(pathOf(a), pathOf(b), m_radii[a] + m_radii[b], m_dt);
    if (!s)
        return false;
    Motion ma = cradle::advance(m_integrators[m_ids[a]], m_motions[a], m_rules.gravity, *s);
    Motion mb = cradle::advance(m_integrators[m_ids[b]], m_motions[b], m_rules.gravity, *s);
    const Vec2 n = normalized(mb.position - ma.position);
    const double closing = dot(ma.velocity - mb.velocity, n);
    const bool swaps = law == CircleLaw::SwapNormal;
    const double massA = massOf(a);
    const double massB = massOf(b);
    const double wa = swaps ? 1.0 : 1.0 / massA;
    const double wb = swaps ? 1.0 : 1.0 / massB;
    const double impulse = (1.0 + e) * closing / ((wa + wb) * dot(n, n));
    const Vec2 changeA = -(impulse * wa) * n;
    const Vec2 changeB = (impulse * wb) * n;
    const double fastest = std::sqrt(
        std::max({lengthSquared(m_motions[a].velocity), lengthSquared(m_motions[b].velocity),
                  lengthSquared(ma.velocity + changeA), lengthSquared(mb.velocity + changeB)}));
    const double slow = leastClosing * (fastest + m_gravity * m_dt);
    if (closing <= slow || reachesWall(a, fastest) || reachesWall(b, fastest))
        return false;

    const bool inOrder = m_ids[a] < m_ids[b];
    Hit hit{.time = m_time - m_dt + *s,
            .step = m_stepNumber,
            .a = static_cast<int>(inOrder ? m_ids[a] : m_ids[b]),
            .b = static_cast<int>(inOrder ? m_ids[b] : m_ids[a]),
            .normal = inOrder ? n : -n,
            .impulse = impulse * wa * massA,
            .beforeA = inOrder ? ma.velocity : mb.velocity,
            .beforeB = inOrder ? mb.velocity : ma.velocity,
            .loss = -0.5 * massA * dot(2.0 * ma.velocity + changeA, changeA)
                    - 0.5 * massB * dot(2.0 * mb.velocity + changeB, changeB)};
    ma.velocity += changeA;
    mb.velocity += changeB;
    hit.afterA = inOrder ? ma.velocity : mb.velocity;
    hit.afterB = inOrder ? mb.velocity : ma.velocity;
    m_found.push_back({run, member, hit});
    first.after = cradle::advance(Integrator::Verlet, ma, m_rules.gravity, m_dt - *s);
    second.after = cradle::advance(Integrator::Verlet, mb, m_rules.gravity, m_dt - *s);
    first.fastest = second.fastest = fastest + m_gravity * m_dt;
    first.disturbed = second.disturbed = true;
    return true;
}

double ContinuousSolver::massOf(Slot slot) const
{
    return mass({.radius = m_radii[slot], .density = m_densities[m_ids[slot]]});
}

/// Whether a circle may come to a wall in this step at \p speed (m/s).
bool ContinuousSolver::reachesWall(Slot slot, double speed) const
{
    const Vec2 place = m_motions[slot].position;
    return m_rules.laws.walls == WallLaw::Reflect
           && std::max(std::abs(place.x), std::abs(place.y)) + m_radii[slot]
                      + m_skin.travel(m_dt, speed + m_gravity * m_dt)
                  >= m_rules.halfWidth;
}

} // namespace cradle
