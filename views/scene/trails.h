// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"
#include "views/scene/scene_draft.h"

namespace cradle {

/// Adds the way of each circle in the last trailSeconds, fading with age; in a crowd only those of
/// the selected and the hovered circle.
/// \param colours  of the circles
void addTrails(DrawList &list, const SceneMoment &moment, const std::vector<QColor> &colours,
               const SceneLook &look);

/// s that the way of the centre of mass reaches back: longer than a trail, for it is one line only
inline constexpr double centreSeconds = 6.0;

/// Adds the centre of mass as a crossed ring, and its way in the last centreSeconds. Without
/// circles there is none.
void addCentreOfMass(SceneDraft &draft, const SceneMoment &moment, double pixelsPerMetre);

} // namespace cradle
