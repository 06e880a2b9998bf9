// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <optional>
#include <span>

namespace cradle {

/// What can be drawn against what, SI units.
enum class Quantity {
    Time,
    X,
    Y,
    VelocityX,
    VelocityY,
    Speed,
    MomentumX,
    MomentumY,
    MomentumSize,
    Kinetic,
    Potential,
    Total,
    Distance,    ///< between the centres of circle 1 and circle 2
    OffExact,    ///< greatest distance of a circle from the exact motion
    EnergyExact, ///< total energy more than in the exact motion
};

/// The quantities that each circle has, and all together: of those, positions and velocities are
/// of the centre of mass.
inline constexpr Quantity quantitiesOfCircles[] = {
    Quantity::X,       Quantity::Y,         Quantity::VelocityX, Quantity::VelocityY,
    Quantity::Speed,   Quantity::MomentumX, Quantity::MomentumY, Quantity::MomentumSize,
    Quantity::Kinetic, Quantity::Potential, Quantity::Total};

/// A quantity, and of what.
struct PhaseVariable {
    static constexpr int together = -1;

    Quantity quantity = Quantity::Time;
    int circle = together; ///< index; of no matter for what no circle has

    [[nodiscard]] bool isOfCircles() const;
    friend bool operator==(const PhaseVariable &, const PhaseVariable &) = default;
};

/// A moment of a run.
struct PhaseMoment {
    double time = 0.0; ///< s
    std::span<const Circle> circles{};
    std::span<const Circle> exact{}; ///< beside it; empty where nothing runs
};

/// The number of \p variable at \p moment of a run of \p preset; nullopt where there is none.
[[nodiscard]] std::optional<double> valueOf(const PhaseVariable &variable,
                                            const PhaseMoment &moment, const Preset &preset);

/// "v_x", with the second letter as a subscript; "" for what has no symbol.
[[nodiscard]] QString symbolOf(Quantity quantity);
/// "Velocity to the right".
[[nodiscard]] QString nameOf(Quantity quantity);
[[nodiscard]] QString unitOf(Quantity quantity);
/// "v_x 1", as at an axis.
[[nodiscard]] QString textOf(const PhaseVariable &variable);

} // namespace cradle
