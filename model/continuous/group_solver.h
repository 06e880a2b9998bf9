// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/broad_phase.h"
#include "model/continuous/continuous_step.h"
#include "model/continuous/pile_step.h"
#include "model/continuous/step_groups.h"

namespace cradle {

/// Takes the groups of a crowd through a step, each from its start: two that meet once by
/// pairStep(), piles by PileStep, all others by ContinuousStep. If a member thereby leaves its free
/// flight and could reach a circle outside, that joins, and the group starts again.
///
/// Keeps its working memory, and the pushes of piles, between steps.
class GroupSolver
{
public:
    /// Forgets the steps before.
    void start(const Rules &rules);
    /// Solves \p groups, whose members learn where they are at the end of \p step.
    /// \param hits  are appended, in the order of time
    /// \param resting  overwritten: pairs that stay in touch
    void run(Crowd &crowd, const BroadPhase &near, const TimeStep &step, StepGroups &groups,
             std::vector<Hit> &hits, std::vector<Crowd::Pair> &resting);

private:
    /// A member, group by group and in the order of the circles.
    struct Place {
        std::uint32_t group = 0;
        std::uint32_t id = 0;
        std::uint32_t member = 0;

        friend bool operator<(const Place &x, const Place &y)
        {
            return std::pair(x.group, x.id) < std::pair(y.group, y.id);
        }
    };
    /// What is found of the group of a member; it counts if nobody has joined that since.
    template <class What>
    struct Found {
        std::uint32_t run = 0;
        std::uint32_t member = 0;
        What what{};

        [[nodiscard]] bool counts(StepGroups &groups) const
        {
            return groups[groups.groupOf(member)].run == run;
        }
    };

    void findChanged(const Crowd &crowd, StepGroups &groups);
    void solve(std::span<const Place> group, const Crowd &crowd, const BroadPhase &near,
               const TimeStep &step, StepGroups &groups);
    bool solvePair(std::span<const Place> group, const Crowd &crowd, const BroadPhase &near,
                   const TimeStep &step, StepGroups &groups);
    void tellHits(StepGroups &groups, std::vector<Hit> &hits);

    std::vector<Place> m_changed; ///< members of the groups that are to be solved
    std::vector<Found<Hit>> m_hits;
    std::vector<Found<Crowd::Pair>> m_resting;

    ContinuousStep m_step;
    PileStep m_pile;
    Rules m_rules{}; ///< of a group
    World m_world;   ///< its circles
    std::vector<std::uint32_t> m_ids;
    std::vector<Hit> m_found; ///< its hits
    std::vector<std::pair<double, std::uint32_t>>
        m_sequence; ///< time and index of those that count
};

} // namespace cradle
