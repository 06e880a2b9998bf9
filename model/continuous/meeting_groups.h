// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/broad_phase.h"
#include "model/continuous/step_groups.h"

namespace cradle {

/// Groups who meets in a step, as far as free flight tells. Who sleeps with one of them wakes.
/// \param resting  were in touch at the end of the step before
/// \param due  may first meet in this step
/// \param groups  overwritten
/// \param inVain  overwritten: of those due, who does not meet after all
void findGroups(Crowd &crowd, double dt, std::span<const Crowd::Pair> resting,
                std::span<const Crowd::Pair> due, StepGroups &groups,
                std::vector<Crowd::Pair> &inVain);

/// Lets all that can reach a pile in the step join it: a pile costs too much to be solved again for
/// each of them.
void foreseePiles(Crowd &crowd, const BroadPhase &near, StepGroups &groups);

/// Lets all join the group of a member that it could reach before the step ends, as it has left its
/// free flight.
void widen(Crowd &crowd, const BroadPhase &near, std::uint32_t member, StepGroups &groups);

} // namespace cradle
