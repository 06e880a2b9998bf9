// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"
#include "model/run/stepper.h"

#include <optional>

namespace cradle {

/// The exact motion beside a run: the same circles from the same start, moved by Timing::Exact from
/// event to event on parabolas, whatever integrator, timing or program moves the run. Between hits
/// that is the closed formula, x(t) = x₀ + v₀ t + ½ g t², so what is between the two is the error
/// of the run. Where the laws let nothing meet, the circles fly their parabolas out of the square.
///
/// Every frame of the run has one of the same number and time here, as long as it is kept there.
class ShadowRun
{
public:
    /// Larger scenes have none. Hits drive neighbouring motions of a gas apart exponentially, so
    /// that after a few hits each nothing is left to compare, and outlines by the hundred hide what
    /// they should show.
    static constexpr std::size_t mostCircles = 50;

    /// \param scene  with at most mostCircles circles and no fault, else there is no run
    /// \param laws   what happens when circles meet walls and each other; their timing is not asked
    ShadowRun(const Preset &scene, const Laws &laws);

    /// Comes up to the newest frame of \p run, a recording of the same scene, or goes back to it
    /// where that was truncated. Frames that were dropped there before this was first called are
    /// run through but not kept.
    void follow(const Recording &run);

    /// The circles beside frame \p index of the run; none if there is no run or no such frame.
    [[nodiscard]] std::span<const Circle> circles(qint64 index) const;

    /// Whether there is a run.
    [[nodiscard]] bool isPossible() const { return m_stepper.has_value(); }

private:
    void moveTo(double time);

    double m_timestep; ///< s
    World m_world;
    std::optional<Stepper> m_stepper; ///< none if there is no run
    Recording m_recording;
    qint64 m_offset = 0;     ///< index in the run of the first frame here
    std::vector<Hit> m_hits; ///< of the step that runs
};

} // namespace cradle
