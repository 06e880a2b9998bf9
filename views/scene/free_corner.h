// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"

namespace cradle {

/// A corner of the viewport, and what would lie under a picture that stands there.
struct FreeCorner {
    QRectF frame{};     ///< px
    double price = 0.0; ///< 0.5 for an arrow's tip, 1 for a circle, 100 for what is reserved
};

/// Where a picture of \p size (px) covers the least of the scene at \p moment, and none of
/// \p reserved (px) if that can be had.
[[nodiscard]] FreeCorner freeCorner(const SceneMoment &moment, const Camera &camera, QSizeF size,
                                    const std::vector<QRectF> &reserved);

} // namespace cradle
