// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_flight.h"

namespace cradle {

/// That gravity leaves out a step in which a circle comes to the floor or goes from it, or acts
/// twice in that of the hit; nothing where the walls do not turn circles under gravity.
/// \param flight  of the same program, which is right
[[nodiscard]] std::optional<LawDeviation> fallAtFloor(const QString *program, const Ground &ground,
                                                      const MeasuredFlight &flight);

} // namespace cradle
