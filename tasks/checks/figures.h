// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/integrator.h"
#include "model/world/measurements.h"

#include <QString>

/// How messages of checks name things and write numbers.
namespace cradle::motion {

[[nodiscard]] QString wallName(Wall wall);                            ///< "right wall"
[[nodiscard]] const char *integratorInEnglish(Integrator integrator); ///< "symplectic Euler"
[[nodiscard]] QString integratorName(Integrator integrator);

/// \p value for people, in any language: four digits, and the whole part of up to a million, with
/// a point.
[[nodiscard]] QString figure(double value);
[[nodiscard]] QString figure(Vec2 value); ///< "(2, 0)"
/// As figure(), but with as many digits more as tell \p value from \p other, beside which it
/// stands.
[[nodiscard]] QString figureBeside(double value, double other);
[[nodiscard]] QString figureBeside(Vec2 value, Vec2 other);

} // namespace cradle::motion
