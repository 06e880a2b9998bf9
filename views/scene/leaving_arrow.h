// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/arrow_lanes.h"
#include "views/scene/camera.h"
#include "views/scene/draw_list.h"

namespace cradle {

/// The part of \p stretch that is seen, a little inside the edges of the picture; all of it if it
/// does not begin there.
[[nodiscard]] Stretch visiblePart(const Stretch &stretch, const Camera &camera);

/// Adds \p arrow to \p list. One that leaves the picture ends at its edge instead, behind a break:
/// two strokes across that say that it is longer than drawn. One that has no room for that leaves.
void addArrow(DrawList &list, const DrawList::Arrow &arrow, const Camera &camera);

} // namespace cradle
