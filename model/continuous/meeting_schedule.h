// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/broad_phase.h"

#include <array>

namespace cradle {

/// Who may first meet in which of the steps until the next sort; in none before.
///
/// Between two disturbances the centres of a pair approach each other in a straight line from step
/// to step, whatever their integrators, so the first step of a meeting is a quadratic; what bends
/// inside a step is added to the reach (docs/physics.md, 6).
class MeetingSchedule
{
public:
    /// After a sort: puts down all pairs.
    void fill(const Crowd &crowd, const BroadPhase &near);
    /// Puts down anew whom a circle may meet that has been disturbed.
    void addAround(const Crowd &crowd, const BroadPhase &near, Crowd::Slot slot);
    /// Puts down anew two that were due and did not meet.
    void addAgain(const Crowd &crowd, const BroadPhase &near, const Crowd::Pair &pair);

    /// Who may meet in the step that many after the sort.
    [[nodiscard]] const std::vector<Crowd::Pair> &due(std::size_t index) const
    {
        return m_due[index];
    }

private:
    using Slot = Crowd::Slot;

    void addPair(const Crowd &crowd, const BroadPhase &near, const Crowd::Pair &pair,
                 bool disturbed);
    void addSleeper(const Crowd &crowd, const BroadPhase &near, const Crowd::Pair &pair);
    void addWalls(const Crowd &crowd, const BroadPhase &near, Slot slot);
    void putDown(double time, const BroadPhase &near, const Crowd::Pair &pair);

    std::array<std::vector<Crowd::Pair>, SortSkin::mostSteps> m_due;
};

} // namespace cradle
