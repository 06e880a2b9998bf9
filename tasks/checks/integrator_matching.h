// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/motion.h"

/// Which integrators the steps of a circle agree with.
namespace cradle {

/// Whether \p integrator makes the place that circle \p i has after step \p k, from the state
/// before; \p tolerance in m, times 1 + distance from the origin.
[[nodiscard]] bool agrees(Integrator integrator, const Observation &o, int i, qint64 k,
                          Vec2 gravity, double tolerance = motion::samePosition);

/// All integrators that step \p k agrees with.
[[nodiscard]] std::vector<Integrator> agreeingIntegrators(const Observation &o, int i, qint64 k,
                                                          Vec2 gravity);

/// The integrators that all free steps of circle \p i agree with; Verlet and Runge-Kutta 4 always
/// come together, and without gravity all four do. Empty if none agrees.
[[nodiscard]] std::vector<Integrator>
matchingIntegrators(const CheckSpec &check, const Observation &o, int i, Vec2 gravity);

/// "symplectic Euler"; "velocity Verlet or Runge-Kutta 4".
[[nodiscard]] QString namesOf(const std::vector<Integrator> &integrators);

} // namespace cradle
