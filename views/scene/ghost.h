// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"
#include "views/scene/scene_builder.h"
#include "views/scene/scene_draft.h"

#include <span>
#include <vector>

namespace cradle {

/// The circles of \p recording at \p time (s), between two frames on the straight line from one to
/// the other; none before its first and after its last frame.
[[nodiscard]] std::vector<Circle> circlesAt(const Recording &recording, double time);

/// How an outline is broken: the exact motion is told from any other ghost by it.
enum class Outline { Dashed, Dotted };

/// Adds the broken outlines of the circles of \p ghost that can be told from the real ones, and
/// what is between the two.
/// \param colours  of the circles
void addGhost(DrawList &list, std::span<const Circle> circles, std::span<const Circle> ghost,
              const std::vector<QColor> &colours, const Camera &camera,
              Outline outline = Outline::Dashed);

/// Adds the ghosts of \p moment, each with a word for what it is beside the outline that is
/// farthest off.
void addGhosts(SceneDraft &draft, const SceneMoment &moment, const std::vector<QColor> &colours,
               const Camera &camera);

} // namespace cradle
