// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

class Simulation;

/// A sentence on how far the moment shown is from the exact motion: the energy that the run has
/// more (J), the greatest distance of a circle, and of several the root mean square too (m). Empty
/// where no exact motion runs beside the run.
[[nodiscard]] QString describeDeviation(const Simulation &simulation);

} // namespace cradle
