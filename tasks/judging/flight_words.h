// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_flight.h"

namespace cradle {

/// In what the free motion of \p own is not that of \p right, as far as \p ground asks for it.
[[nodiscard]] std::vector<LawDeviation>
flightDeviations(const MeasuredFlight &own, const MeasuredFlight &right, const Ground &ground);

} // namespace cradle
