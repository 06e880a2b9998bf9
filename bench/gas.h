// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/integrator.h"
#include "model/world/preset.h"

#include <vector>

namespace cradle {

inline constexpr double gasRadius = 0.2;       ///< m
inline constexpr double gasAreaFraction = 0.2; ///< Σ π r² / area of the square
inline constexpr double gasRmsSpeed = 2.0;     ///< m/s
inline constexpr double heapAreaFraction = 0.4;
inline constexpr double heapRmsSpeed = 1.0; ///< m/s, at the start

/// The preset, and its circles as Cradle's solvers are handed them.
struct Gas : Preset {
    std::vector<Circle> bodies;
};

/// \p count equal elastic circles in a reflecting square of half width ½ √(N π r² / φ) m.
/// \param gravity  downwards, m/s²
[[nodiscard]] Gas gas(int count, double gravity);

/// \p count equal circles that fall into a heap: 40 % of the square, e = ½, 9.81 m/s² downwards.
[[nodiscard]] Gas heap(int count);

/// Energy per mass, J/kg: Σ ½ v² + g (y + half width), g pointing down.
[[nodiscard]] double specificEnergy(const Preset &gas, const std::vector<Motion> &motions);

/// The deepest that two circles reach into each other, or one into a wall, in radii; 0 if none do.
/// Infinite where a motion is not finite.
[[nodiscard]] double worstOverlap(const Preset &gas, const std::vector<Motion> &motions);

} // namespace cradle
