// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// When who can meet.

namespace {

/// Shares of a step by which timeRounding may bring a meeting forward.
constexpr double timeRounding = 1e-6;

} // namespace

Path ContinuousSolver::pathOf(Slot slot) const
{
    if (sleeps(slot))
        return {m_motions[slot].position, Vec2{}, Vec2{}};
    const Integrator integrator = m_integrators[m_ids[slot]];
    return {m_motions[slot].position, m_motions[slot].velocity,
            pathCurvature(integrator) * m_rules.gravity};
}

/// Notes that two may meet \p time s from now, and not before.
void ContinuousSolver::putDown(double time, Slot a, Slot b)
{
    const double steps = std::max(0.0, time / m_dt - timeRounding);
    if (steps < static_cast<double>(m_skin.steps() - m_index))
        m_due[m_index + static_cast<std::size_t>(steps)].push_back({a, b});
}

/// Calls visit(b) for those of a run that come near enough in time if they fly straight on; most
/// do not, so this goes without branches: the distance at s is at least √(d² − 2 s approach).
template <class Visit>
void ContinuousSolver::sieve(Slot a, Slot begin, Slot end, double slack, Visit visit) const
{
    constexpr Slot most = 32;
    Slot near[most];
    const Motion first = m_motions[a];
    const double radius = m_radii[a] + slack;
    const double span = 2.0 * static_cast<double>(m_skin.steps() - m_index) * m_dt;
    while (begin < end) {
        const Slot stop = std::min(end, begin + most);
        Slot count = 0;
        for (Slot b = begin; b < stop; ++b) {
            const Vec2 d = m_motions[b].position - first.position;
            const double sum = radius + m_radii[b];
            near[count] = b;
            count +=
                lengthSquared(d) - sum * sum < span * dot(d, first.velocity - m_motions[b].velocity)
                    ? 1U
                    : 0U;
        }
        for (Slot k = 0; k < count; ++k)
            visit(near[k]);
        begin = stop;
    }
}

/// What gravity and different integrators can add to a straight way from now on, m.
double ContinuousSolver::slack(bool disturbed) const
{
    const double span = static_cast<double>(m_skin.steps() - m_index) * m_dt;
    double bends = m_alike ? 0.0 : m_gravity * m_dt * (span + m_dt);
    if (m_sleep.count() > 0) // they do not fall with the others
        bends += m_gravity * span * (0.5 * span + m_dt);
    // What rests may fall, or may be fallen upon, in the next step.
    return bends + (disturbed ? 2.0 * m_gravity * m_dt * m_dt : 0.0);
}

void ContinuousSolver::scheduleAll()
{
    for (auto &due : m_due)
        due.clear();
    const auto small = static_cast<Slot>(m_small);
    const auto all = static_cast<Slot>(m_motions.size());
    const double span = static_cast<double>(m_skin.steps()) * m_dt;
    const double bends = slack(false);
    for (Slot a = 0; a < all; ++a) {
        scheduleWalls(a);
        if (m_rules.laws.circles == CircleLaw::None)
            continue;
        const auto look = [&](Slot begin, Slot end) {
            sieve(a, begin, end, bends, [&](Slot b) { schedulePair(a, b, false); });
        };
        if (a < small) {
            const double travel =
                m_skin.travel(span, std::sqrt(lengthSquared(m_motions[a].velocity)));
            m_grid.visitRunsAfter(a, m_motions[a].position,
                                  m_radii[a] + m_smallRadius + m_skin.width()
                                      + std::min(m_skin.width(), travel),
                                  look);
        }
        look(std::max(a + 1, small), all);
    }
}

/// After a circle was disturbed, or was looked at in vain.
void ContinuousSolver::scheduleAround(Slot slot)
{
    scheduleWalls(slot);
    if (m_rules.laws.circles == CircleLaw::None)
        return;
    const double extra = slack(true);
    const auto look = [&](Slot begin, Slot end) {
        sieve(slot, begin, end, extra, [&](Slot b) {
            if (b != slot)
                schedulePair(slot, b, true);
        });
    };
    const double span = static_cast<double>(m_skin.steps() - m_index) * m_dt;
    const double travel = m_skin.travel(span, std::sqrt(lengthSquared(m_motions[slot].velocity)));
    m_grid.visitRuns(m_motions[slot].position,
                     m_radii[slot] + m_smallRadius + m_skin.width()
                         + std::min(2.0 * m_skin.width(), travel),
                     look);
    look(static_cast<Slot>(m_small), static_cast<Slot>(m_motions.size()));
}

/// \param disturbed  one of them may rest or hang on others, and not fall as it flies
void ContinuousSolver::schedulePair(Slot a, Slot b, bool disturbed)
{
    if (sleeps(a) || sleeps(b)) {
        scheduleSleeper(a, b);
        return;
    }
    const Motion &first = m_motions[a];
    const Motion &second = m_motions[b];
    const Vec2 d = second.position - first.position;
    Vec2 v = second.velocity - first.velocity;
    double reach = m_radii[a] + m_radii[b];
    if (disturbed && m_gravity > 0.0) {
        const double near = reach + m_dt * (std::sqrt(lengthSquared(v)) + 2.0 * m_gravity * m_dt);
        if (lengthSquared(d) <= near * near) {
            putDown(0.0, a, b);
            return;
        }
    }
    if (!m_alike) {
        // From step to step the centres move in a straight line; inside a step the paths of
        // different integrators bend apart by no more than g Δt²/4.
        const double bend =
            pathCurvature(m_integrators[m_ids[b]]) - pathCurvature(m_integrators[m_ids[a]]);
        v += (bend * m_dt) * m_rules.gravity;
        reach += 0.5 * m_gravity * m_dt * m_dt;
    }
    const double approach = -dot(d, v);
    const double gap = lengthSquared(d) - reach * reach;
    const double span = static_cast<double>(m_skin.steps() - m_index) * m_dt;
    // Their distance at s is at least √(d² − 2 s approach).
    if (gap >= 2.0 * span * approach)
        return;
    if (gap <= 0.0) {
        putDown(0.0, a, b);
        return;
    }
    const double discriminant = approach * approach - lengthSquared(v) * gap;
    if (discriminant >= 0.0)
        putDown(gap / (approach + std::sqrt(discriminant)), a, b);
}

void ContinuousSolver::scheduleWalls(Slot slot)
{
    if (m_rules.laws.walls != WallLaw::Reflect || sleeps(slot))
        return;
    const Motion &motion = m_motions[slot];
    const double room = m_rules.halfWidth - m_radii[slot];
    const double safe = room - 2.0 * m_skin.width();
    if (std::abs(motion.position.x) < safe && std::abs(motion.position.y) < safe)
        return;
    const double bend = 0.5 * m_gravity * m_dt * m_dt;
    const double span = static_cast<double>(m_skin.steps() - m_index) * m_dt;
    const Vec2 g = m_rules.gravity;
    // From step to step every integrator is on a parabola.
    const Vec2 v = motion.velocity + (m_dt * (pathCurvature(m_integrators[m_ids[slot]]) - 0.5)) * g;
    double first = infinity;
    for (const Wall side : allWalls) {
        const Vec2 n = outwardNormal(side);
        const auto s =
            timeToLine(room - bend - dot(motion.position, n), dot(v, n), 0.5 * dot(g, n), span);
        first = std::min(first, s.value_or(infinity));
    }
    if (first < infinity)
        putDown(first, slot, wall);
}

bool ContinuousSolver::meetInStep(const Candidates &candidates) const
{
    const Path path = pathOf(candidates.a);
    if (candidates.b != wall)
        return timeToDistance(path, pathOf(candidates.b),
                              m_radii[candidates.a] + m_radii[candidates.b], m_dt)
            .has_value();
    const double room = m_rules.halfWidth - m_radii[candidates.a];
    return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall side) {
        const Vec2 n = outwardNormal(side);
        return timeToLine(room - dot(path.position, n), dot(path.velocity, n), dot(path.curve, n),
                          m_dt)
            .has_value();
    });
}

} // namespace cradle
