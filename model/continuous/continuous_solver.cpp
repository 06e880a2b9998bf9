// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include "model/continuous/crowd_sleep.h"
#include "model/continuous/meeting_groups.h"

#include <algorithm>

namespace cradle {

namespace {

/// Whether steps are the motion itself: free flight without error, hits without loss.
bool stepsAreExact(const Rules &rules)
{
    return rules.restitution == 1.0 && rules.laws.circles != CircleLaw::Stop
           && rules.laws.circles != CircleLaw::SwapVelocities
           && std::all_of(rules.integrators.begin(), rules.integrators.end(),
                          [](Integrator i) { return pathCurvature(i) == 0.5; });
}

/// Into how many parts a step is divided in which circles go \p way m: where that is farther than
/// half their mean free path, all of them would meet in one group. Powers of two, so that a step is
/// not sorted anew because speeds have changed a little.
int partsOf(double way, double freePath)
{
    constexpr double freePaths = 0.5;
    constexpr int mostParts = 1024;
    int parts = 1;
    while (parts < mostParts && way > freePaths * freePath * parts)
        parts *= 2;
    return parts;
}

} // namespace

void ContinuousSolver::start(const Rules &rules, std::span<const Circle> circles)
{
    m_isExact = stepsAreExact(rules);
    if (m_isExact) {
        m_exact.start(rules, circles);
        return;
    }
    m_crowd.start(rules, circles);
    m_near.start(m_crowd);
    m_groups.start(circles.size());
    m_solver.start(rules);
    m_resting.clear();
}

void ContinuousSolver::advance(double dt, double time, qint64 number, std::vector<Hit> &hits)
{
    if (dt == 0.0)
        return;
    if (m_isExact) {
        m_exact.advance(dt, time, number, hits);
        return;
    }
    const int parts = partsOf(m_near.meanSpeed() * dt, m_crowd.freePath);
    for (int part = parts; part-- > 0;)
        advance({dt / parts, time - part * (dt / parts), number}, hits);
}

void ContinuousSolver::advance(const TimeStep &step, std::vector<Hit> &hits)
{
    if (m_crowd.sleep.count() == m_crowd.count() && step.dt == m_near.dt())
        return;
    // Broad phase: sort all into the grid anew, and put down who may first meet in which step.
    if (m_near.isStale(step.dt)) {
        m_near.sort(step.dt, m_crowd, m_resting);
        m_schedule.fill(m_crowd, m_near);
    }
    // Groups: who meets in this step, as far as free flight tells.
    findGroups(m_crowd, step.dt, m_resting, m_schedule.due(m_near.index()), m_groups, m_inVain);
    // Hits and piles: each group from the start of the step, with whom it thereby comes to meet.
    m_solver.run(m_crowd, m_near, step, m_groups, hits, m_resting);
    // Free flight, where nothing is met.
    m_crowd.flyFreely(step.dt);
    for (const StepGroups::Member &member : m_groups)
        m_crowd.motions[member.slot] = member.after;
    // Sleep: leave alone what has long been at rest.
    if (m_crowd.hasPiles) {
        layToSleep(m_crowd, step.dt, m_groups);
        std::erase_if(m_resting, [this](Crowd::Pair pair) { return m_crowd.sleeps(pair.a); });
    }
    // Schedule: whom these may meet next, and when those that did not meet after all.
    m_near.countStep();
    for (const StepGroups::Member &member : m_groups) {
        m_near.note(member.fastest);
        if (!m_near.isOver())
            m_schedule.addAround(m_crowd, m_near, member.slot);
    }
    for (const Crowd::Pair &pair : m_inVain) {
        if (!m_near.isOver())
            m_schedule.addAgain(m_crowd, m_near, pair);
    }
}

void ContinuousSolver::read(std::span<Circle> circles) const
{
    if (m_isExact)
        m_exact.read(circles);
    else
        m_crowd.read(circles);
}

} // namespace cradle
