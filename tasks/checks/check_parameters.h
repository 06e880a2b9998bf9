// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/parameter_makers.h"

/// The parameters that several kinds of checks have.
namespace cradle::parameters {

/// Larger numbers than these are mistakes, m, m/s, m/s².
inline constexpr double farthest = 1e6;

[[nodiscard]] ParameterInfo gravity();
[[nodiscard]] ParameterInfo collisions();
[[nodiscard]] ParameterInfo restitution();
[[nodiscard]] ParameterInfo hits();     ///< of walls, by all circles together
[[nodiscard]] ParameterInfo visits();   ///< to a wall, by each circle
[[nodiscard]] ParameterInfo contacts(); ///< of circles 1 and 2
[[nodiscard]] ParameterInfo freeFlight();
[[nodiscard]] ParameterInfo integrators();
[[nodiscard]] ParameterInfo laws();

/// How far off is still right; \p standard where it is left out.
[[nodiscard]] ParameterInfo tolerance(double standard, const char *unit);
/// A tolerance that has no unit: of a whole, from 0 to 1.
[[nodiscard]] ParameterInfo share(double standard, const QString &help);

// Values that are not looked at if they are left out: one for each of the circles; of the circle.
[[nodiscard]] ParameterInfo list(const char *name, const QString &label, const char *unit);
[[nodiscard]] ParameterInfo vector(const char *name, const QString &label, const char *unit);
[[nodiscard]] ParameterInfo positive(const char *name, const QString &label, const char *unit);

} // namespace cradle::parameters
