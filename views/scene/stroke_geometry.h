// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/camera.h"
#include "views/scene/draw_list.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace cradle {

/// The pixels that \p line runs through. A solid horizontal or vertical one is moved onto whole
/// device pixels (\p dpr to a logical one), where it is sharp; both painters do so alike.
[[nodiscard]] inline QLineF pixelLine(const DrawList::Line &line, const Camera &camera, double dpr)
{
    const QPointF from = camera.toPixels(line.from);
    const QPointF to = camera.toPixels(line.to);
    const bool odd = std::lround(line.width * dpr) % 2 != 0;
    const auto sharp = [&](double pixel) {
        const double device = pixel * dpr;
        return (odd ? std::floor(device) + 0.5 : std::round(device)) / dpr;
    };
    const auto whole = [&](double pixel) { return std::round(pixel * dpr) / dpr; };
    if (line.dash != DrawList::Dash{})
        return {from, to};
    if (line.from.x == line.to.x) {
        const double x = sharp(from.x());
        return {x, whole(from.y()), x, whole(to.y())};
    }
    if (line.from.y == line.to.y) {
        const double y = sharp(from.y());
        return {whole(from.x()), y, whole(to.x()), y};
    }
    return {from, to};
}

/// Length (px) of the head of an arrow that is \p shaft px long.
[[nodiscard]] inline double headLength(const DrawList::Arrow &arrow, double shaft)
{
    return std::min(arrow.head, shaft);
}

} // namespace cradle
