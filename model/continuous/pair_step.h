// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/broad_phase.h"
#include "model/world/world.h"

#include <optional>

namespace cradle {

/// What comes of two circles of a crowd that meet once in a step.
struct PairStep {
    Hit hit{};
    Motion afterA{}; ///< at the end of the step
    Motion afterB{};
    double fastest = 0.0; ///< that one of them may have been in the step, m/s
};

/// Takes two circles that meet once in a step, far from walls, through it: what nearly every hit of
/// a gas is. The same as ContinuousStep would do, without looking for anything else.
/// \param a  of the two the one that comes first in the order of the circles
/// \return nothing if it is not that simple
[[nodiscard]] std::optional<PairStep> pairStep(const Crowd &crowd, const SortSkin &skin,
                                               const TimeStep &step, Crowd::Slot a, Crowd::Slot b);

} // namespace cradle
