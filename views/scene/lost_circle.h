// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/circle.h"
#include "views/scene/camera.h"
#include "views/scene/scene_draft.h"

namespace cradle {

/// Whether no part of \p circle is in the picture.
[[nodiscard]] bool isLost(const Circle &circle, const Camera &camera);

/// Adds a head of an arrow at the edge of the picture that points to where \p circle, which is not
/// in it, has gone, with \p name beside it.
void addPointer(SceneDraft &draft, const Circle &circle, const QString &name, const QColor &colour,
                const Camera &camera);

} // namespace cradle
