// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/ground.h"

namespace cradle {

/// What becomes of a circle that comes to rest at the floor and that of \p right, another program,
/// does not do: it loses speed along the floor, or stays above it.
[[nodiscard]] std::optional<LawDeviation> restAtFloor(const QString &program, const QString &right,
                                                      const Ground &ground);

} // namespace cradle
