// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/continuous_solver.h"
#include "model/exact/exact_solver.h"
#include "model/run/discrete_step.h"
#include "model/world/rules.h"
#include "model/world/world.h"

#include <optional>

namespace cradle {

/// Advances a world by one step under the laws of a preset. Any world of that preset may be handed
/// to it; the one that it left at the latest step is carried on at once, as queues and grids are
/// kept for it, another is begun anew.
///
/// Exact timing follows a heap as long as it can; from then on its contacts are merged, as
/// continuous timing does it.
class Stepper
{
public:
    explicit Stepper(const Preset &preset);

    /// One step of the preset's timestep; hits of the step are appended to \p hits.
    /// time = step × timestep: no drift.
    void advance(World &world, std::vector<Hit> &hits);

    /// One step of \p dt s, of any length from 0 (the "frame time" of the original lab).
    void advanceBy(World &world, double dt, std::vector<Hit> &hits);

    /// A step to \p end, the time at its end, but for exact timing only through \p events events:
    /// each takes about a microsecond. \return whether the step is done; if not, \p world and
    /// \p hits are as before, and the next call with the same arguments goes on with it
    [[nodiscard]] bool advanceWithin(std::size_t events, World &world, double dt, double end,
                                     std::vector<Hit> &hits);

    /// Since when the contacts of the run are merged that exact timing could not follow any
    /// longer, s; none if it is exact, or of another timing.
    [[nodiscard]] std::optional<double> mergedFrom() const { return m_mergedFrom; }

private:
    bool move(std::size_t events, World &world, double dt, std::vector<Hit> &hits);
    bool moveExactly(std::size_t events, World &world, double dt, std::vector<Hit> &hits);
    void moveContinuously(World &world, double dt, std::vector<Hit> &hits);
    void merge(World &world, std::vector<Hit> &hits);
    [[nodiscard]] bool isLeft(const World &world) const;

    Rules m_rules;
    double m_timestep;
    DiscreteStep m_discrete;
    ContinuousStep m_continuous;
    ExactSolver m_exact;
    ContinuousSolver m_crowd;
    std::vector<Circle> m_left;         ///< as a solver of crowds left them at the latest step
    std::optional<double> m_mergedFrom; ///< s
    bool m_isUnfinished = false;        ///< the step of exact timing that was begun
    std::vector<Hit> m_found;           ///< of that step
};

} // namespace cradle
