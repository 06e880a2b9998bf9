// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_wall.h"

namespace cradle {

/// In what the walls of \p own are not those of \p right, as far as \p ground asks for them.
[[nodiscard]] std::vector<LawDeviation>
wallDeviations(const MeasuredWalls &own, const MeasuredWalls &right, const Ground &ground);

/// That who comes into a corner is left beyond one of its walls, which turns it only later.
[[nodiscard]] std::optional<LawDeviation>
lateInCorner(const MeasuredWalls &own, const MeasuredWalls &right, const Ground &ground);

} // namespace cradle
