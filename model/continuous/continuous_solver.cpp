// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// The skin as a share of the mean spacing of the circles: wide enough that sorting is rare,
/// narrow enough that few pairs are looked at.
constexpr double skinShare = 0.65;
/// A step in which the circles would fly farther than so many mean free paths is divided, up to
/// this often: else all of them would meet in one group.
constexpr double freePaths = 0.5;
constexpr int mostParts = 1024;

/// Whether steps are the motion itself: free flight without error, hits without loss.
bool stepsAreExact(const Rules &rules)
{
    return rules.restitution == 1.0 && rules.laws.circles != CircleLaw::Stop
           && rules.laws.circles != CircleLaw::SwapVelocities
           && std::all_of(rules.integrators.begin(), rules.integrators.end(),
                          [](Integrator i) { return pathCurvature(i) == 0.5; });
}

} // namespace

void ContinuousSolver::start(const Rules &rules, std::span<const Circle> circles)
{
    m_isExact = stepsAreExact(rules);
    if (m_isExact)
        m_exact.start(rules, circles);
    else
        startSteps(rules, circles);
}

void ContinuousSolver::startSteps(const Rules &rules, std::span<const Circle> circles)
{
    m_rules = {.halfWidth = rules.halfWidth,
               .gravity = rules.gravity,
               .restitution = rules.restitution,
               .laws = rules.laws};
    m_groupRules = m_rules;
    m_gravity = length(rules.gravity);
    m_piles =
        m_gravity > 0.0 && rules.restitution < 1.0 && rules.laws.circles == CircleLaw::Impulse;
    m_pile.clear();
    m_sleep.start(circles.size());
    m_slotOf.assign(circles.size(), 0);
    m_integrators = rules.integrators;
    m_alike = std::adjacent_find(m_integrators.begin(), m_integrators.end(), std::not_equal_to<>())
              == m_integrators.end();
    const std::size_t count = circles.size();
    m_motions.clear();
    m_radii.clear();
    m_densities.clear();
    Vec2 low = count > 0 ? circles[0].position : Vec2{};
    Vec2 high = low;
    GiantsApart apart = giantsApart(circles);
    for (const std::uint32_t id : apart.ids) {
        const Circle &c = circles[id];
        m_motions.push_back({c.position, c.velocity});
        m_radii.push_back(c.radius);
        low = {std::min(low.x, c.position.x), std::min(low.y, c.position.y)};
        high = {std::max(high.x, c.position.x), std::max(high.y, c.position.y)};
    }
    m_ids = std::move(apart.ids);
    m_small = apart.small;
    m_smallRadius = apart.smallRadius;
    for (const Circle &c : circles)
        m_densities.push_back(c.density);
    const double span = rules.laws.walls == WallLaw::Reflect
                            ? 2.0 * rules.halfWidth
                            : std::max(high.x - low.x, high.y - low.y) + m_smallRadius;
    // λ = A / (2 √2 N d), the mean free path of hard discs of diameter d while they are few.
    double diameters = 0.0;
    for (const Circle &c : circles)
        diameters += 2.0 * c.radius;
    m_freePath = diameters > 0.0 ? span * span / (2.0 * std::sqrt(2.0) * diameters) : infinity;
    findMeanSpeed();
    m_skinWidth =
        skinShare * span / std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)));
    m_resting.clear();
    m_groups.start(count);
    m_dt = 0.0;
}

void ContinuousSolver::advance(double dt, double time, qint64 step, std::vector<Hit> &hits)
{
    if (dt == 0.0)
        return;
    if (m_isExact) {
        m_exact.advance(dt, time, step, hits);
        return;
    }
    // Powers of two, so that a step is not sorted anew because speeds have changed a little.
    int parts = 1;
    while (parts < mostParts && m_meanSpeed * dt > freePaths * m_freePath * parts)
        parts *= 2;
    m_stepNumber = step;
    for (int part = parts; part-- > 0;)
        advancePart(dt / parts, time - part * (dt / parts), hits);
}

/// A step: who meets, what comes of it, and who may meet these next.
void ContinuousSolver::advancePart(double dt, double time, std::vector<Hit> &hits)
{
    m_time = time;
    if (m_sleep.count() == m_motions.size() && dt == m_dt)
        return;
    // Sort all into the grid anew, and put down who may first meet in which of the next steps.
    if (dt != m_dt || m_index >= m_skin.steps())
        sort(dt);
    // Gather who meets in this step, as far as free flight tells.
    findGroups();
    // Solve each group from the start of the step, with whom it thereby comes to meet.
    solveGroups(hits);
    // Fly freely where nothing is met.
    flyFreely();
    for (const Member &member : m_groups)
        m_motions[member.slot] = member.after;
    // Leave alone what has long been at rest.
    if (m_piles)
        layToSleep();
    // Put down whom these may meet in the steps that are left, and those that did not meet after
    // all.
    ++m_index;
    scheduleMembers();
}

void ContinuousSolver::scheduleMembers()
{
    for (const Member &member : m_groups) {
        m_skin.note(member.fastest, m_index);
        if (m_index < m_skin.steps())
            scheduleAround(member.slot);
    }
    for (const Candidates &pair : m_inVain) {
        if (m_index >= m_skin.steps())
            break;
        if (pair.b == wall)
            scheduleWalls(pair.a);
        else
            schedulePair(pair.a, pair.b, false);
    }
}

void ContinuousSolver::findMeanSpeed()
{
    m_meanSpeed = 0.0;
    for (const Motion &motion : m_motions)
        m_meanSpeed += std::sqrt(lengthSquared(motion.velocity));
    m_meanSpeed /= static_cast<double>(std::max<std::size_t>(1, m_motions.size()));
}

void ContinuousSolver::flyFreely()
{
    if (m_alike && !m_integrators.empty() && m_sleep.count() == 0) {
        const Integrator integrator = m_integrators.front();
        for (Motion &motion : m_motions)
            motion = cradle::advance(integrator, motion, m_rules.gravity, m_dt);
        return;
    }
    for (Slot slot = 0; slot < m_motions.size(); ++slot)
        m_motions[slot] = freely(slot);
}

Motion ContinuousSolver::freely(Slot slot) const
{
    if (sleeps(slot))
        return m_motions[slot];
    return cradle::advance(m_integrators[m_ids[slot]], m_motions[slot], m_rules.gravity, m_dt);
}

void ContinuousSolver::sort(double dt)
{
    m_grid.build(m_small, [this](std::size_t i) { return m_motions[i].position; });
    const std::span<const std::uint32_t> sorted = m_grid.sorted();
    m_sortedMotions.resize(m_motions.size());
    m_sortedRadii.resize(m_motions.size());
    m_sortedIds.resize(m_motions.size());
    double fastest = 0.0;
    for (std::size_t slot = 0; slot < m_motions.size(); ++slot) {
        const std::size_t from = slot < m_small ? sorted[slot] : slot;
        m_sortedMotions[slot] = m_motions[from];
        m_sortedRadii[slot] = m_radii[from];
        m_sortedIds[slot] = m_ids[from];
        fastest = std::max(fastest, lengthSquared(m_motions[from].velocity));
    }
    if (!m_resting.empty()) {
        std::vector<Slot> moved(m_motions.size());
        for (Slot slot = 0; slot < moved.size(); ++slot)
            moved[slot < m_small ? sorted[slot] : slot] = slot;
        for (Candidates &pair : m_resting)
            pair = {moved[pair.a], moved[pair.b]};
    }
    m_motions.swap(m_sortedMotions);
    m_radii.swap(m_sortedRadii);
    m_ids.swap(m_sortedIds);
    for (Slot slot = 0; slot < m_ids.size() && m_sleep.count() > 0; ++slot)
        m_slotOf[m_ids[slot]] = slot;

    findMeanSpeed();
    m_dt = dt;
    m_index = 0;
    m_skin.start(dt, m_gravity, m_skinWidth, std::sqrt(fastest));
    scheduleAll();
}

void ContinuousSolver::read(std::span<Circle> circles) const
{
    if (m_isExact) {
        m_exact.read(circles);
        return;
    }
    for (std::size_t slot = 0; slot < m_motions.size(); ++slot) {
        Circle &circle = circles[m_ids[slot]];
        circle.position = m_motions[slot].position;
        circle.velocity = m_motions[slot].velocity;
    }
}

} // namespace cradle
