// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"

#include <optional>

class QPainter;

namespace cradle {

/// The place where two circles, or a circle and a wall, touch in the hit that is shown, enlarged in
/// a corner of the scene. A plain value.
struct Loupe {
    QRectF frame{};             ///< px of the viewport
    double magnification = 1.0; ///< against the scene
    DrawList list{};
    Camera camera{}; ///< its viewport is the frame

    friend bool operator==(const Loupe &, const Loupe &) = default;
};

/// Looks at where the newest hit shown at \p moment happened from so near that the smaller circle
/// fills about two fifths of the height; nullopt where no hit is shown.
/// \param viewport  px
[[nodiscard]] std::optional<Camera> cameraAtHit(const SceneMoment &moment, int selected,
                                                QSizeF viewport);

/// The loupe for \p moment, in a corner that covers no circle and none of \p look.reserved. None
/// while the run goes on, where no hit is shown, where no corner is free or large enough, and where
/// the scene itself is already about as near.
[[nodiscard]] std::optional<Loupe> loupeAt(const SceneMoment &moment, const SceneOptions &options,
                                           const SceneLook &look);

void paintLoupe(QPainter &painter, const Loupe &loupe, const QFont &font);

} // namespace cradle
