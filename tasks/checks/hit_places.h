// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <optional>

namespace cradle {

/// Where the step of a hit takes one of the two circles. A hit leaves places sensible if the way of
/// that step is put together from parts that a way of answering it may have:
///     made = α free + β bounced + γ apart,   0 ≤ α, β ≤ 1,   0 ≤ γ ≤ 2 overlap
/// where γ > 0 only for α = 1 or if they overlapped before. α = 0 goes back to the old place, β > 0
/// goes on with the new velocity, γ moves them apart by what they overlap, which one of them or
/// both may do. So no circle is put nearer to the other than its own velocities take it, nor to the
/// side of them.
struct HitPlace {
    Vec2 apart{};         ///< along the line of centres, away from the other, a unit vector
    double turn = 0.0;    ///< tangent of the angle by which that line may turn in the step
    double overlap = 0.0; ///< of the rims, the most that a program may see in the step, m
    bool isLate = false; ///< they overlapped when the step began: α from −1, back to before that
    Vec2 free{};         ///< its way in that step without a hit, m
    Vec2 bounced{};      ///< its way in a step with the velocity that the hit gave it, m
    Vec2 made{};         ///< its way in that step, m
};

/// That a hit put a circle where it does not belong.
struct Misplacement {
    enum class Where {
        Into,  ///< nearer to the other
        Aside, ///< across the line of centres
        Away,  ///< farther from the other than they need
    };
    Where where = Where::Into;
    double by = 0.0; ///< beyond what its velocities explain and, where it is away, the overlap, m

    friend constexpr bool operator==(const Misplacement &, const Misplacement &) = default;
};

/// The worst that is wrong with it.
/// \param slack  what gravity and rounding make of a way in a step, m
[[nodiscard]] std::optional<Misplacement> misplacementOf(const HitPlace &place, double slack);

} // namespace cradle
