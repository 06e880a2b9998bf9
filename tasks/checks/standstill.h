// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

#include <optional>

namespace cradle::motion {

/// What is wrong if circle \p i stands still, or nearly so, in the steps behind step \p k, in which
/// it was hit, although the velocity that it has then takes it away from all walls and circles that
/// are near. A program may put it back in the step of the hit, and wait for a step or two.
[[nodiscard]] std::optional<Fault> standstillAfter(const Observation &o, int i, qint64 k,
                                                   Vec2 gravity);

} // namespace cradle::motion
