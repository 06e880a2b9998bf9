// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/recording.h"
#include "views/scene/camera.h"
#include "views/scene/draw_list.h"

#include <span>
#include <vector>

namespace cradle {

/// The circles of \p recording at \p time (s), between two frames on the straight line from one to
/// the other; none before its first and after its last frame.
[[nodiscard]] std::vector<Circle> circlesAt(const Recording &recording, double time);

/// Adds the broken outlines of the circles of \p ghost that can be told from the real ones, and
/// what is between the two.
/// \param colours  of the circles
void addGhost(DrawList &list, std::span<const Circle> circles, std::span<const Circle> ghost,
              const std::vector<QColor> &colours, const Camera &camera);

} // namespace cradle
