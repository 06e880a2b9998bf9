// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/group_solver.h"
#include "model/continuous/meeting_schedule.h"
#include "model/exact/exact_solver.h"

namespace cradle {

/// Continuous timing for crowds: ContinuousStep for the few circles that meet something in a step,
/// free flight for all others.
///
/// Circles are sorted into a grid every so many steps. Then, and whenever a circle's motion is
/// disturbed, each pair within reach is put down for the first step in which it can meet; only in
/// that step its time of impact is looked for. Nothing is missed (docs/physics.md, 6).
///
/// A step in which most circles of a crowd would meet several others is divided into parts; so
/// there are no groups of thousands.
///
/// Under gravity, where hits take energy, large groups are piles, which PileStep moves. A pile that
/// has been at rest for a while sleeps, as does what lies still: it stays where it is, and no step
/// looks at it, until something that moves may meet one of it in a step.
///
/// Where every integrator follows the parabola and no hit loses anything, steps that miss no hit
/// and exact timing are the same motion; then ExactSolver does the work, which needs no steps.
class ContinuousSolver
{
public:
    /// Begins with \p circles under \p rules.
    void start(const Rules &rules, std::span<const Circle> circles);
    /// One step of \p dt s. Hits are appended to \p hits; \p time (s) and \p number are those at
    /// its end.
    void advance(double dt, double time, qint64 number, std::vector<Hit> &hits);
    /// Writes places and velocities to \p circles.
    void read(std::span<Circle> circles) const;

private:
    void advance(const TimeStep &step, std::vector<Hit> &hits);

    bool m_isExact = false; ///< m_exact does the work
    ExactSolver m_exact;

    Crowd m_crowd;
    BroadPhase m_near;
    MeetingSchedule m_schedule;
    StepGroups m_groups; ///< of the latest step
    GroupSolver m_solver;
    std::vector<Crowd::Pair> m_resting; ///< stay in touch from step to step
    std::vector<Crowd::Pair> m_inVain;  ///< were due in the latest step and did not meet
};

} // namespace cradle
