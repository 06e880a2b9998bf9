// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/lost_circle.h"

#include "views/theme.h"

#include <QLineF>
#include <QRectF>

#include <algorithm>

namespace cradle {

namespace {

constexpr double tipGap = 6.0;    ///< px from the edge of the picture to the tip
constexpr double headSize = 12.0; ///< px
constexpr double nameGap = 4.0;   ///< px

} // namespace

bool isLost(const Circle &circle, const Camera &camera)
{
    const double radius = circle.radius * camera.pixelsPerMetre();
    const QRectF around = QRectF({}, camera.viewport()).adjusted(-radius, -radius, radius, radius);
    return !around.contains(camera.toPixels(circle.position));
}

void addPointer(SceneDraft &draft, const Circle &circle, const QString &name, const QColor &colour,
                const Camera &camera)
{
    const QPointF there = camera.toPixels(circle.position);
    const QSizeF size = camera.viewport();
    const QPointF tip(std::clamp(there.x(), tipGap, std::max(tipGap, size.width() - tipGap)),
                      std::clamp(there.y(), tipGap, std::max(tipGap, size.height() - tipGap)));
    const Vec2 to = camera.toMetres(tip);
    const Vec2 outwards = normalized(circle.position - to);
    const Vec2 from = to - (headSize / camera.pixelsPerMetre()) * outwards;
    draft.list.arrows.push_back({.from = from, .to = to, .colour = colour, .head = headSize});
    draft.wishes.push_back({.label = {.anchor = from, .text = name, .colour = theme().text},
                            .direction = -outwards,
                            .clearance = nameGap});
}

} // namespace cradle
