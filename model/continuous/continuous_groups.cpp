// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// Circles that meet in a step are solved in groups.

namespace {

/// Larger groups under gravity, where hits take energy, are piles: moment by moment a heap of 25
/// takes a hundred times as long, and its overlaps grow to a twentieth of a radius.
constexpr std::size_t largestGroup = 8;

} // namespace

/// The member that a circle is from now on; who sleeps with it wakes.
std::uint32_t ContinuousSolver::activate(Slot slot)
{
    if (!m_groups.has(slot)) {
        m_groups.add(slot);
        if (sleeps(slot))
            wake(slot);
    }
    return m_groups.of(slot);
}

void ContinuousSolver::join(Slot a, Slot b)
{
    const std::uint32_t first = activate(a);
    m_groups.join(first, activate(b));
}

/// Who meets in this step, as far as free flight tells.
void ContinuousSolver::findGroups()
{
    m_groups.clear();
    m_kicked = 0.0;
    m_inVain.clear();
    for (const Candidates &pair : m_resting)
        join(pair.a, pair.b);
    for (const Candidates &due : m_due[m_index]) {
        if (sleeps(due.a) && (due.b == wall || sleeps(due.b)))
            continue;
        if (!meetInStep(due))
            m_inVain.push_back(due);
        else if (due.b == wall)
            activate(due.a);
        else
            join(due.a, due.b);
    }
    m_due[m_index].clear();
    m_resting.clear();
}

void ContinuousSolver::solveGroups(std::vector<Hit> &hits)
{
    m_found.clear();
    m_touching.clear();
    m_runs = 0;
    while (true) {
        if (m_piles)
            foreseePiles();
        m_order.clear();
        for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
            const std::uint32_t group = m_groups.groupOf(i);
            if (m_groups[group].changed)
                m_order.push_back({group, m_ids[m_groups[i].slot], i});
        }
        if (m_order.empty())
            break;
        std::sort(m_order.begin(), m_order.end());
        for (std::size_t begin = 0; begin < m_order.size();) {
            const std::span<const Place> places = groupFrom(begin);
            m_groups[places[0].group].changed = false;
            m_groups[places[0].group].run = ++m_runs;
            solve(places);
            begin += places.size();
        }
        for (const Place &place : m_order)
            m_kicked = std::max(m_kicked, m_groups[place.member].fastest);
        for (const Place &place : m_order) {
            const Member &member = m_groups[place.member];
            if (member.disturbed && member.fastest > member.foreseen)
                widen(place.member);
        }
    }
    // In the order of time, those of one moment as they were found.
    std::erase_if(m_found, [this](const Found &found) {
        return m_groups[m_groups.groupOf(found.member)].run != found.run;
    });
    m_sequence.clear();
    for (std::uint32_t i = 0; i < m_found.size(); ++i)
        m_sequence.emplace_back(m_found[i].hit.time, i);
    std::sort(m_sequence.begin(), m_sequence.end());
    for (const auto &[time, i] : m_sequence)
        hits.push_back(m_found[i].hit);
    for (const Touching &touching : m_touching) {
        if (m_groups[m_groups.groupOf(touching.member)].run == touching.run)
            m_resting.push_back(touching.pair);
    }
}

bool ContinuousSolver::isPile(std::size_t members) const
{
    return m_piles && members > largestGroup;
}

/// The members of a group that stand in m_order from \p begin on.
std::span<const ContinuousSolver::Place> ContinuousSolver::groupFrom(std::size_t begin) const
{
    std::size_t end = begin + 1;
    while (end < m_order.size() && m_order[end].group == m_order[begin].group)
        ++end;
    return std::span(m_order).subspan(begin, end - begin);
}

/// A pile costs too much to be solved again for each that joins it: who may reach it does so at
/// once.
void ContinuousSolver::foreseePiles()
{
    for (bool grown = true; grown;) {
        grown = false;
        for (std::uint32_t i = 0; i < m_groups.size(); ++i) { // while more of them join
            const Member &group = m_groups[m_groups.groupOf(i)];
            if (m_groups[i].foreseen >= 0.0 || !group.changed || !isPile(group.size))
                continue;
            const double fastest = length(m_motions[m_groups[i].slot].velocity) + m_gravity * m_dt;
            m_groups[i].fastest = m_groups[i].foreseen = fastest;
            m_kicked = std::max(m_kicked, fastest);
            widen(i);
            grown = true;
        }
    }
}

/// Takes a group through the step, from its start.
void ContinuousSolver::solve(std::span<const Place> places)
{
    if (places.size() == 2
        && solvePair(places[0].member, places[1].member, m_groups[places[0].group].run))
        return;
    m_world.time = m_time;
    m_world.step = m_stepNumber;
    m_world.circles.clear();
    m_groupRules.integrators.clear();
    for (const Place &place : places) {
        const Slot slot = m_groups[place.member].slot;
        m_world.circles.push_back({m_motions[slot].position, m_motions[slot].velocity,
                                   m_radii[slot], m_densities[m_ids[slot]]});
        m_groupRules.integrators.push_back(m_integrators[m_ids[slot]]);
        m_groups[place.member].fastest = lengthSquared(m_motions[slot].velocity);
    }
    m_hits.clear();
    const bool pile = isPile(places.size());
    if (pile) {
        m_people.clear();
        for (const Place &place : places)
            m_people.push_back(place.id);
        m_pile.run(m_groupRules, m_world, m_people, m_dt, m_hits);
    } else {
        m_step.run(m_groupRules, m_world, m_dt, m_hits);
    }

    const std::uint32_t run = m_groups[places[0].group].run;
    const auto memberOf = [&](int index) { return places[static_cast<std::size_t>(index)].member; };
    for (Hit hit : m_hits) {
        Member &a = m_groups[memberOf(hit.a)];
        a.fastest = std::max(a.fastest, lengthSquared(hit.afterA));
        const std::uint32_t owner = memberOf(hit.a);
        if (hit.kind == Hit::Kind::Circle) {
            Member &b = m_groups[memberOf(hit.b)];
            b.fastest = std::max(b.fastest, lengthSquared(hit.afterB));
            hit.b = static_cast<int>(m_ids[b.slot]);
        }
        hit.a = static_cast<int>(m_ids[a.slot]);
        m_found.push_back({run, owner, hit});
    }
    for (const auto &[a, b] : pile ? m_pile.pushingPairs() : m_step.restingPairs())
        m_touching.push_back(
            {run, memberOf(a), {m_groups[memberOf(a)].slot, m_groups[memberOf(b)].slot}});
    for (std::size_t i = 0; i < places.size(); ++i) {
        Member &member = m_groups[places[i].member];
        const Circle &circle = m_world.circles[i];
        member.after = {circle.position, circle.velocity};
        member.fastest = std::sqrt(std::max(member.fastest, lengthSquared(circle.velocity)));
        member.disturbed = member.after != freely(member.slot);
    }
}

/// How fast a circle at most is in this step as far as is known, m/s: another may have kicked it.
double ContinuousSolver::fastestOf(Slot slot) const
{
    const double speed = std::sqrt(lengthSquared(m_motions[slot].velocity));
    return m_groups.has(slot) ? std::max(speed, m_groups[m_groups.of(slot)].fastest) : speed;
}

/// A member that has left its free flight takes in whom it could reach before the step ends.
void ContinuousSolver::widen(std::uint32_t index)
{
    const Member member = m_groups[index];
    if (m_rules.laws.circles == CircleLaw::None)
        return;
    const Vec2 place = m_motions[member.slot].position;
    const double travel = m_skin.travel(m_dt, member.fastest);
    const double reach = m_radii[member.slot] + travel;
    const auto consider = [&](Slot other, double otherTravel) {
        const double near = reach + m_radii[other] + otherTravel;
        if (other != member.slot && lengthSquared(m_motions[other].position - place) <= near * near)
            join(member.slot, other);
    };
    // Most are farther than even the fastest could come. Where this one was kicked harder than the
    // grid knows, others that were, too, may come from farther than it knows.
    double farthest = m_skin.driftAfter(m_index + 1);
    double foreseen =
        m_skin.travel(m_dt, m_skin.fastest() + m_gravity * static_cast<double>(m_index) * m_dt);
    if (member.fastest > m_skin.fastest()) {
        const double kicked = m_skin.travel(m_dt, m_kicked);
        farthest = std::max(farthest, m_skin.driftAfter(m_index) + kicked);
        foreseen = std::max(foreseen, kicked);
    }
    const double far = reach + m_smallRadius + foreseen;
    const auto look = [&](Slot begin, Slot end) {
        for (Slot other = begin; other < end; ++other) {
            if (lengthSquared(m_motions[other].position - place) <= far * far)
                consider(other, m_skin.travel(m_dt, fastestOf(other)));
        }
    };
    m_grid.visitRuns(place, reach + m_smallRadius + farthest, look);
    for (auto giant = static_cast<Slot>(m_small); giant < m_motions.size(); ++giant)
        consider(giant, m_skin.travel(m_dt, fastestOf(giant)));
}

} // namespace cradle
