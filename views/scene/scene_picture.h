// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/camera.h"
#include "views/scene/draw_list.h"
#include "views/scene/loupe.h"
#include "views/scene/momentum_inset.h"

#include <QFont>

#include <vector>

class QPainter;

namespace cradle {

/// A short text in a rounded frame that lies over the scene.
struct Chip {
    enum class Place {
        TopRight, ///< what is so all the time
        Bottom,   ///< what was just refused, and why
        Centre,   ///< what to do in an empty scene
        Pointer   ///< the value that is dragged, and why it is refused
    };

    Place place = Place::TopRight;
    QString text{};
    QString detail{}; ///< below the text; Pointer only
    bool warning = false;
    int row = 0;       ///< at the top right, one below the other
    QPointF pointer{}; ///< px; Pointer stands beside it, Bottom goes to the top for a low one

    friend bool operator==(const Chip &, const Chip &) = default;
};

/// All that a canvas shows of the scene at one moment.
struct ScenePicture {
    DrawList list{};
    Camera camera{};
    QFont font{};
    std::vector<Chip> chips{};
    std::optional<MomentumInset> inset{};
    std::optional<Loupe> loupe{};
    QRectF band{};           ///< px: what a rubber band is about to select; null if there is none
    bool focusFrame = false; ///< the keyboard acts here
};

/// Draws what lies over the shapes: labels, chips and the focus frame; the same for both painters.
void paintOverlay(QPainter &painter, const ScenePicture &picture);

/// The rectangle (px) that \p chip covers in \p viewport.
[[nodiscard]] QRectF chipRect(const Chip &chip, QSizeF viewport, const QFont &font);

} // namespace cradle
