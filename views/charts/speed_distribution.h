// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/circle.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cradle {

/// What a crowd of circles would be like as a gas in equilibrium.
///
/// There each of the two parts of a velocity is Gaussian with variance kT/m, so a speed has the
/// density of Maxwell and Boltzmann in two dimensions (a Rayleigh distribution)
///     f(v) = (m v / kT) exp(−m v² / 2kT),   kT = Σ ½ m v² / N:
/// each of the two directions of motion holds ½ kT. Unequal masses have a curve each; the scaled
/// speed u = v √(m / m̄), m̄ the mean mass, has the curve of m̄ for all of them. Of equal masses
/// u = v.
struct GasState {
    double temperature = 0.0; ///< kT, J: the mean kinetic energy of a circle
    double meanMass = 0.0;    ///< m̄, kg
    bool isMixed = false;     ///< masses differ

    /// σ = √(kT / m̄), m/s: the most frequent speed, and the width of the curve. 0 at rest.
    [[nodiscard]] double spread() const;
};

/// All zero if there are no circles.
[[nodiscard]] GasState gasState(std::span<const Circle> circles);

/// u = v √(m / m̄), m/s; exactly v where the masses are equal.
[[nodiscard]] double scaledSpeed(const Circle &circle, const GasState &gas);

/// f(v) of GasState, s/m: \p speed ≥ 0 and \p spread > 0, m/s.
[[nodiscard]] double maxwellDensity(double speed, double spread);

/// The share of circles slower than \p speed in equilibrium: 1 − exp(−v² / 2σ²).
[[nodiscard]] double maxwellShareBelow(double speed, double spread);

/// The distance of Kolmogorov and Smirnov, 0 to 1: the greatest difference between the share of
/// circles that are slower than a speed and what maxwellShareBelow() says. 1 if nothing moves.
[[nodiscard]] double distanceFromMaxwell(std::span<const Circle> circles);

/// The distance that one of a hundred gases of \p count circles in equilibrium exceeds by chance,
/// with the temperature taken from the circles themselves. As u² is then exponential, it follows
/// from (D − 0.2/N)(√N + 0.26 + 0.5/√N) = 1.308. Source: M. A. Stephens, EDF statistics for
/// goodness of fit and some comparisons, J. Am. Stat. Assoc. 69 (1974), 730–737.
[[nodiscard]] double distanceByChance(std::size_t count);

/// Scaled speeds counted into bins of equal width from 0 on, over as many moments as are added.
class SpeedBins
{
public:
    /// \param width  of a bin, m/s, > 0
    SpeedBins(double width, std::size_t count);

    void add(std::span<const Circle> circles, const GasState &gas);

    [[nodiscard]] double width() const { return m_width; } ///< m/s
    /// The share of all circles in each bin, 0 to 1. A bin contains its lower bound.
    [[nodiscard]] std::vector<double> shares() const;
    [[nodiscard]] double shareBeyond() const; ///< faster than the last bin, 0 to 1

private:
    double m_width;
    std::vector<std::size_t> m_counts;
    std::size_t m_beyond = 0;
    std::size_t m_total = 0;
};

} // namespace cradle
