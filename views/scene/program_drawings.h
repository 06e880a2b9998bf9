// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "views/scene/camera.h"
#include "views/scene/scene_draft.h"

#include <span>

namespace cradle {

/// With more drawings than this, labels are not kept clear of them, and of their texts only the
/// first ones are shown.
inline constexpr std::size_t manyDrawings = 100;

/// The colour that a program calls \p name, "orange" or "#rrggbb", darkened or lightened just so
/// far that it shows in the scene; the text's colour if there is no such colour.
[[nodiscard]] QColor drawingColour(const QString &name);

/// Adds the arrows, lines and points of \p drawings, over the circles.
void addDrawnShapes(DrawList &list, std::span<const Drawing> drawings, const Camera &camera);

/// Adds the texts of \p drawings that have their place in the scene: those of arrows at the tips.
void addDrawnTexts(SceneDraft &draft, std::span<const Drawing> drawings, const Camera &camera);

/// Adds a line over the discs; lines of the list are below them.
void addLineAbove(DrawList &list, Vec2 from, Vec2 to, const QColor &colour, double width);

} // namespace cradle
