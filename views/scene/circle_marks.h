// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"
#include "views/scene/scene_draft.h"

namespace cradle {

// What stands at a circle besides its disc.

/// The name that a circle was given, or its number where it has none or only "circle N".
[[nodiscard]] QString shortName(const Preset &preset, int index);

/// Wishes for that name: inside the disc where it has room there, else beside it.
/// \param colour  of the disc
void addName(SceneDraft &draft, const SceneMoment &moment, const Circle &circle, int index,
             const QColor &colour, const SceneLook &look);

/// An arrow along the velocity, with its speed in m/s if it is to be \p labelled.
void addVelocity(SceneDraft &draft, const SceneMoment &moment, const Circle &circle,
                 const QColor &colour, bool labelled, const Camera &camera);

/// A ring around a circle that is selected.
void addRing(DrawList &list, const Circle &circle, const Camera &camera, const QColor &colour);

/// The ring of a circle that is pointed at or selected, and the grip of its velocity.
void addMarks(DrawList &list, const Circle &circle, const SceneMoment &moment,
              const SceneLook &look, bool selected);

/// Where a drag wants a circle that cannot be there.
void addRefused(DrawList &list, const Circle &circle, const SceneMoment &moment);

} // namespace cradle
