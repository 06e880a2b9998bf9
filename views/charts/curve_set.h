// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/recording.h"
#include "views/charts/min_max_pyramid.h"

#include <array>

namespace cradle {

/// What is shown of a momentum.
enum class MomentumPart { X, Y, Length };

/// Momentum and energy of one circle, or of all, over the run.
struct MotionCurves {
    std::array<MinMaxPyramid, 3> momentum{}; ///< by MomentumPart, kg m/s
    MinMaxPyramid kinetic{};                 ///< J
    MinMaxPyramid total{};                   ///< kinetic and potential energy, J
    MinMaxPyramid kineticUpTo{};             ///< of this circle and those before it, J
};

/// The curves of a run; a value. A step with a hit is drawn upright at the time of the (first) hit.
class CurveSet
{
public:
    /// With more circles there are only the curves of all together.
    static constexpr std::size_t maxCircles = 8;

    /// How many circles have curves of their own.
    [[nodiscard]] std::size_t circleCount() const { return m_circles.size(); }
    [[nodiscard]] const MotionCurves &circle(std::size_t index) const { return m_circles[index]; }
    [[nodiscard]] const MotionCurves &sum() const { return m_sum; }
    [[nodiscard]] const MinMaxPyramid &potential() const { return m_potential; }
    [[nodiscard]] const MinMaxPyramid &total() const { return m_sum.total; }
    /// Kinetic energy that hits have taken since the start, J.
    [[nodiscard]] const MinMaxPyramid &dissipated() const { return m_dissipated; }
    /// Energy that the integrator or the program has made since the start, J; negative if it lost
    /// some: total + dissipated in hits − total at the start.
    [[nodiscard]] const MinMaxPyramid &made() const { return m_made; }
    /// The total of the first frame read, J.
    [[nodiscard]] double startTotal() const { return m_start; }
    /// The greatest |p| of any circle or of all, kg m/s: the scale of the run.
    [[nodiscard]] double momentumScale() const;

    [[nodiscard]] qint64 bytes() const; ///< memory held
    /// A copy whose oldest part is forgotten where it would hold more than \p maxBytes.
    [[nodiscard]] CurveSet within(qint64 maxBytes) const;

    /// Begins anew, for a run of \p circles circles.
    void begin(std::size_t circles);
    /// Reads the next frame of \p recording, a run of \p preset.
    void read(const Recording &recording, const Preset &preset, qint64 index);
    void dropBefore(double time);
    /// Forgets an eighth of the time kept.
    void dropOldest();

private:
    template <typename Visit>
    void forEach(Visit visit);

    std::vector<MotionCurves> m_circles;
    MotionCurves m_sum;
    MinMaxPyramid m_potential;
    MinMaxPyramid m_dissipated;
    MinMaxPyramid m_made;
    qint64 m_nextHit = 0; ///< of all hits ever
    double m_lost = 0.0;  ///< J, up to the last frame read
    double m_start = 0.0; ///< J
};

} // namespace cradle
