// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/integrator.h"
#include "model/world/preset.h"

#include <QString>

namespace cradle {

// What laws and methods are called, wherever the window names them.
[[nodiscard]] QString nameOf(WallLaw law);           ///< "Reflect"
[[nodiscard]] QString nameOf(CircleLaw law);         ///< "Swap normal parts"
[[nodiscard]] QString nameOf(Timing timing);         ///< "Discrete"
[[nodiscard]] QString nameOf(Integrator integrator); ///< "Symplectic Euler"
/// As short as a cell of a narrow table wants it: "S. Euler".
[[nodiscard]] QString briefNameOf(Integrator integrator);

} // namespace cradle
