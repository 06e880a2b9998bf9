// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

#include <optional>

/// How much of an observation shows the motion of a circle that nothing meets.
namespace cradle {

/// In how many steps nothing can meet circle \p i.
[[nodiscard]] qint64 freeSteps(const CheckSpec &check, const Observation &o, int i, Vec2 gravity);

/// What is missing to judge the motion of circle \p i, which was free for \p steps steps; nullopt
/// if that is as much as the check wants to see ("free").
[[nodiscard]] std::optional<Fault> tooLittleFlight(const CheckSpec &check, const Observation &o,
                                                   int i, qint64 steps, Vec2 gravity);

} // namespace cradle
