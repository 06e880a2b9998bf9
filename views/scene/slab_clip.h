// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <optional>

namespace cradle {

/// A part of a way, as shares of it: 0 is where it starts, 1 where it ends.
struct WayPart {
    double enter = 0.0;
    double leave = 1.0;
};

/// The part of the way \p along from \p start that lies in the box from \p low to \p high, its rim
/// included (slab method). \return nullopt if none does
[[nodiscard]] std::optional<WayPart> partInside(Vec2 start, Vec2 along, Vec2 low, Vec2 high);

} // namespace cradle
