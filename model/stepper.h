// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous_step.h"
#include "model/discrete_step.h"
#include "model/rules.h"
#include "model/world.h"

namespace cradle {

/// Advances a world by one step under the laws of a preset. Keeps working memory between steps
/// but nothing of the run, so that any world of that preset may be handed to it.
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

    Rules m_rules;
    double m_timestep;
    DiscreteStep m_discrete;
    ContinuousStep m_continuous;
};

} // namespace cradle
