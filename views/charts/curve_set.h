// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"
#include "model/world/measurements.h"
#include "views/charts/min_max_pyramid.h"

#include <QFlags>

#include <array>
#include <optional>

namespace cradle {

/// What is shown of a momentum.
enum class MomentumPart { X, Y, Length };

/// Curves that are kept only where they are wanted. The total energy of all circles and what hits
/// dissipated are kept always.
enum class CurveGroup : unsigned {
    MomentumX = 1, ///< of each circle and of all
    MomentumY = 2,
    MomentumLength = 4,
    KineticOfEach = 8,
    KineticUpTo = 16,
    TotalOfEach = 32,
    Kinetic = 64, ///< of all
    Potential = 128,
    Made = 256,
    All = 511
};
using CurveGroups = QFlags<CurveGroup>;

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
    /// Energy that hits, and resting on something, have taken since the start, J; negative where
    /// they made some, as going back to an old place that is higher does.
    [[nodiscard]] const MinMaxPyramid &dissipated() const { return m_dissipated; }
    /// Energy that the integrator or the program has made since the start, J; negative if it lost
    /// some: total + dissipated in hits − total at the start. It is none in steps with a hit.
    [[nodiscard]] const MinMaxPyramid &made() const { return m_made; }
    /// The total of the first frame read, J.
    [[nodiscard]] double startTotal() const { return m_start.value_or(0.0); }
    /// The greatest |p| of any circle or of all so far, kg m/s: the scale of the run.
    [[nodiscard]] double momentumScale() const { return m_momentumScale; }
    /// The greatest kinetic or potential energy of all so far, J, without its sign.
    [[nodiscard]] double energyScale() const { return m_energyScale; }
    [[nodiscard]] CurveGroups groups() const { return m_groups; }

    [[nodiscard]] qint64 bytes() const; ///< memory held
    /// A copy whose oldest part is forgotten where it would hold more than \p maxBytes.
    [[nodiscard]] CurveSet within(qint64 maxBytes) const;

    /// Begins anew, for a run of \p circles circles, with the same groups.
    void begin(std::size_t circles);
    /// Keeps \p groups and no others. Those that are new are read up to the frame before \p next,
    /// as far back as the total is kept.
    void setGroups(CurveGroups groups, const Recording &recording, const Preset &preset,
                   qint64 next);
    /// All groups of the run of which this has some, read from \p recording up to the frame before
    /// \p next; the oldest part is forgotten where they would hold more than \p maxBytes.
    [[nodiscard]] CurveSet whole(const Recording &recording, const Preset &preset, qint64 next,
                                 qint64 maxBytes) const;
    /// Reads the next frame of \p recording, a run of \p preset.
    void read(const Recording &recording, const Preset &preset, qint64 index);
    void dropBefore(double time);
    /// Forgets an eighth of the time kept.
    void dropOldest();

private:
    /// How far the hits were read.
    struct Losses {
        /// What a circle had to do with others or a wall, in steps.
        struct Touch {
            qint64 last = -EncounterLog::restingSteps - 1; ///< hit at the end of a step
            qint64 until = -1;                             ///< it rests, up to this one
        };

        qint64 nextHit = 0;           ///< of all hits ever
        double sum = 0.0;             ///< J
        std::vector<Touch> touches{}; ///< of every circle
    };
    class Moment;

    template <typename Visit>
    void forEach(Visit visit);
    void countLosses(const Recording &recording, const Preset &preset, qint64 index,
                     const Moment &moment);
    Totals add(CurveGroups groups, const Moment &moment, std::span<const Circle> circles,
               const Preset &preset, double lost);
    void clear(CurveGroups groups);

    std::vector<MotionCurves> m_circles;
    MotionCurves m_sum;
    MinMaxPyramid m_potential;
    MinMaxPyramid m_dissipated;
    MinMaxPyramid m_made;
    CurveGroups m_groups = CurveGroup::All;
    Losses m_losses;               ///< up to the last frame read
    std::optional<double> m_start; ///< J
    double m_momentumScale = 0.0;  ///< kg m/s
    double m_energyScale = 0.0;    ///< J
};

} // namespace cradle
