// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/slab_clip.h"

#include <algorithm>

namespace cradle {

std::optional<WayPart> partInside(Vec2 start, Vec2 along, Vec2 low, Vec2 high)
{
    WayPart part;
    const auto clip = [&part](double from, double delta, double least, double most) {
        if (delta == 0.0)
            return from >= least && from <= most;
        const double a = (least - from) / delta;
        const double b = (most - from) / delta;
        part.enter = std::max(part.enter, std::min(a, b));
        part.leave = std::min(part.leave, std::max(a, b));
        return part.enter <= part.leave;
    };
    if (!clip(start.x, along.x, low.x, high.x) || !clip(start.y, along.y, low.y, high.y))
        return std::nullopt;
    return part;
}

} // namespace cradle
