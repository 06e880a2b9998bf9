// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/group_solver.h"

#include "model/continuous/meeting_groups.h"
#include "model/continuous/pair_step.h"

#include <algorithm>

namespace cradle {

void GroupSolver::start(const Rules &rules)
{
    m_rules = rules;
    m_pile.clear();
}

void GroupSolver::run(Crowd &crowd, const BroadPhase &near, const TimeStep &step,
                      StepGroups &groups, std::vector<Hit> &hits, std::vector<Crowd::Pair> &resting)
{
    m_hits.clear();
    m_resting.clear();
    std::uint32_t runs = 0;
    while (true) {
        foreseePiles(crowd, near, groups);
        // Solve each group that is new, or that somebody has joined.
        findChanged(crowd, groups);
        if (m_changed.empty())
            break;
        for (auto begin = m_changed.begin(); begin != m_changed.end();) {
            const auto end = std::find_if(begin, m_changed.end(), [&](const Place &place) {
                return place.group != begin->group;
            });
            groups[begin->group].changed = false;
            groups[begin->group].run = ++runs;
            solve({begin, end}, crowd, near, step, groups);
            begin = end;
        }
        // Let those join whom a member may now reach.
        for (const Place &place : m_changed)
            groups.note(groups[place.member].fastest);
        for (const Place &place : m_changed) {
            const StepGroups::Member &member = groups[place.member];
            if (member.disturbed && member.fastest > member.foreseen)
                widen(crowd, near, place.member, groups);
        }
    }
    tellHits(groups, hits);
    resting.clear();
    for (const Found<Crowd::Pair> &pair : m_resting) {
        if (pair.counts(groups))
            resting.push_back(pair.what);
    }
}

/// Lists the members of groups that must be solved.
void GroupSolver::findChanged(const Crowd &crowd, StepGroups &groups)
{
    m_changed.clear();
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        const std::uint32_t group = groups.groupOf(i);
        if (groups[group].changed)
            m_changed.push_back({group, crowd.ids[groups[i].slot], i});
    }
    std::sort(m_changed.begin(), m_changed.end());
}

/// Takes a group through the step, from its start.
void GroupSolver::solve(std::span<const Place> group, const Crowd &crowd, const BroadPhase &near,
                        const TimeStep &step, StepGroups &groups)
{
    if (group.size() == 2 && solvePair(group, crowd, near, step, groups))
        return;
    m_world.time = step.end;
    m_world.step = step.number;
    m_world.circles.clear();
    m_rules.integrators.clear();
    m_ids.clear();
    for (const Place &place : group) {
        StepGroups::Member &member = groups[place.member];
        m_world.circles.push_back(crowd.circle(member.slot));
        m_rules.integrators.push_back(crowd.integrator(member.slot));
        m_ids.push_back(place.id);
        member.fastest = lengthSquared(crowd.motions[member.slot].velocity);
    }
    m_found.clear();
    const bool pile = crowd.isPile(group.size());
    if (pile)
        m_pile.run(m_rules, m_world, m_ids, step.dt, m_found);
    else
        m_step.run(m_rules, m_world, step.dt, m_found);

    const std::uint32_t run = groups[group[0].group].run;
    const auto memberOf = [&](int index) { return group[static_cast<std::size_t>(index)].member; };
    const auto idOf = [&](int index) {
        return static_cast<int>(group[static_cast<std::size_t>(index)].id);
    };
    for (Hit hit : m_found) {
        const std::uint32_t owner = memberOf(hit.a);
        StepGroups::Member &a = groups[owner];
        a.fastest = std::max(a.fastest, lengthSquared(hit.afterA));
        if (hit.kind == Hit::Kind::Circle) {
            StepGroups::Member &b = groups[memberOf(hit.b)];
            b.fastest = std::max(b.fastest, lengthSquared(hit.afterB));
            hit.b = idOf(hit.b);
        }
        hit.a = idOf(hit.a);
        m_hits.push_back({run, owner, hit});
    }
    for (const auto &[a, b] : pile ? m_pile.pushingPairs() : m_step.restingPairs())
        m_resting.push_back(
            {run, memberOf(a), {groups[memberOf(a)].slot, groups[memberOf(b)].slot}});
    for (std::size_t i = 0; i < group.size(); ++i) {
        StepGroups::Member &member = groups[group[i].member];
        const Circle &circle = m_world.circles[i];
        member.after = {circle.position, circle.velocity};
        member.fastest = std::sqrt(std::max(member.fastest, lengthSquared(circle.velocity)));
        member.disturbed = member.after != crowd.freely(member.slot, step.dt);
    }
}

/// \return false if the two are no simple meeting; then nothing was done
bool GroupSolver::solvePair(std::span<const Place> group, const Crowd &crowd,
                            const BroadPhase &near, const TimeStep &step, StepGroups &groups)
{
    StepGroups::Member &a = groups[group[0].member];
    StepGroups::Member &b = groups[group[1].member];
    const std::optional<PairStep> pair = pairStep(crowd, near.skin(), step, a.slot, b.slot);
    if (!pair)
        return false;
    m_hits.push_back({groups[group[0].group].run, group[0].member, pair->hit});
    a.after = pair->afterA;
    b.after = pair->afterB;
    a.fastest = b.fastest = pair->fastest;
    a.disturbed = b.disturbed = true;
    return true;
}

/// Tells of the hits that count in the order of time, those of one moment as they were found.
void GroupSolver::tellHits(StepGroups &groups, std::vector<Hit> &hits)
{
    std::erase_if(m_hits, [&](const Found<Hit> &hit) { return !hit.counts(groups); });
    m_sequence.clear();
    for (std::uint32_t i = 0; i < m_hits.size(); ++i)
        m_sequence.emplace_back(m_hits[i].what.time, i);
    std::sort(m_sequence.begin(), m_sequence.end());
    for (const auto &[time, i] : m_sequence)
        hits.push_back(m_hits[i].what);
}

} // namespace cradle
