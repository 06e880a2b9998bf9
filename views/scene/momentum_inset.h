// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"

class QPainter;

namespace cradle {

/// The momenta of all circles tip to tail and their sum, as a small picture in a corner of the
/// scene: what a hit takes from one circle it gives to the other, and the sum stays. A plain
/// value; places in px of the viewport.
struct MomentumInset {
    static constexpr double padding = 8.0;  ///< px between the frame and what is in it
    static constexpr double shortest = 1.0; ///< px; a shorter arrow is a dot

    struct Arrow {
        QPointF from{};
        QPointF to{};
        QColor colour{};
        QString label{};   ///< number of the circle, or Σ; empty where there is no room
        QPointF labelAt{}; ///< middle of the label
        bool isSum = false;

        friend bool operator==(const Arrow &, const Arrow &) = default;
    };

    QRectF frame{};
    std::vector<Arrow> arrows{}; ///< circles with momentum in their order, the sum last
    double scaleLength = 0.0;    ///< px, of the bar that tells the scale
    double scaleMomentum = 0.0; ///< that the bar stands for, kg m/s: 1, 2 or 5 times a power of ten

    friend bool operator==(const MomentumInset &, const MomentumInset &) = default;
};

/// With more circles than this the arrows could not be told apart.
inline constexpr std::size_t mostMomenta = 6;

/// The inset for \p moment, in the corner that covers the fewest circles and none of \p reserved
/// (px). None with fewer than two or more than mostMomenta circles, where nothing moves, and where
/// the viewport is so small that it would hide the scene.
[[nodiscard]] std::optional<MomentumInset> momentumInset(const SceneMoment &moment,
                                                         const Camera &camera, const QFont &font,
                                                         const std::vector<QRectF> &reserved);

void paintInset(QPainter &painter, const MomentumInset &inset, const QFont &font);

} // namespace cradle
