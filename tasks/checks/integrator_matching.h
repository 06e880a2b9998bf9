// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

namespace cradle {

/// The integrators that all free steps of circle \p i agree with; Verlet and Runge-Kutta 4 always
/// come together, and without gravity all four do. Empty if none agrees.
[[nodiscard]] std::vector<Integrator>
matchingIntegrators(const CheckSpec &check, const Observation &o, int i, Vec2 gravity);

/// "symplectic Euler"; "velocity Verlet or Runge-Kutta 4".
[[nodiscard]] QString namesOf(const std::vector<Integrator> &integrators);

} // namespace cradle
