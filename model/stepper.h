// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous_solver.h"
#include "model/discrete_step.h"
#include "model/exact_solver.h"
#include "model/rules.h"
#include "model/world.h"

namespace cradle {

/// Advances a world by one step under the laws of a preset. Any world of that preset may be handed
/// to it; the one that it left at the latest step is carried on at once, as queues and grids are
/// kept for it, another is begun anew.
class Stepper
{
public:
    explicit Stepper(const Preset &preset);

    /// One step of the preset's timestep; hits of the step are appended to \p hits.
    /// time = step × timestep: no drift.
    void advance(World &world, std::vector<Hit> &hits);

    /// One step of \p dt s, of any length from 0 (the "frame time" of the original lab).
    void advanceBy(World &world, double dt, std::vector<Hit> &hits);

private:
    void move(World &world, double dt, std::vector<Hit> &hits);
    template <class Solver>
    void carryOn(Solver &solver, World &world, double dt, std::vector<Hit> &hits);

    Rules m_rules;
    double m_timestep;
    DiscreteStep m_discrete;
    ContinuousStep m_continuous;
    ExactSolver m_exact;
    ContinuousSolver m_crowd;
    std::vector<Circle> m_left; ///< as a solver of crowds left them at the latest step
};

} // namespace cradle
