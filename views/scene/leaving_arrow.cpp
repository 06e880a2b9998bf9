// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/leaving_arrow.h"

#include <QRectF>

#include <algorithm>

namespace cradle {

namespace {

constexpr double edgeGap = 8.0;    ///< px from the edge of the picture
constexpr double stub = 4.0;       ///< px of shaft between the break and the head
constexpr double breakGap = 4.0;   ///< px
constexpr double breakReach = 5.0; ///< px that a stroke reaches to either side
constexpr double breakSlope = 2.0; ///< px that its ends are off along the arrow
constexpr double breakWidth = 1.5; ///< px
constexpr double leastShaft = 2.0; ///< px before the break

} // namespace

Stretch visiblePart(const Stretch &stretch, const Camera &camera)
{
    const QPointF from = camera.toPixels(stretch.from);
    const QPointF way = camera.toPixels(stretch.to) - from;
    const QRectF seen =
        QRectF({}, camera.viewport()).adjusted(edgeGap, edgeGap, -edgeGap, -edgeGap);
    if (!seen.contains(from))
        return stretch;
    double share = 1.0;
    if (way.x() != 0.0)
        share =
            std::min(share, ((way.x() > 0.0 ? seen.right() : seen.left()) - from.x()) / way.x());
    if (way.y() != 0.0)
        share =
            std::min(share, ((way.y() > 0.0 ? seen.bottom() : seen.top()) - from.y()) / way.y());
    return {stretch.from, stretch.from + share * (stretch.to - stretch.from)};
}

void addArrow(DrawList &list, const DrawList::Arrow &arrow, const Camera &camera)
{
    const Stretch seen = visiblePart({arrow.from, arrow.to}, camera);
    const double pixel = 1.0 / camera.pixelsPerMetre(); // m
    const double tail = (arrow.head + stub + breakGap) * pixel;
    if (seen.to == arrow.to || length(seen.to - seen.from) < tail + leastShaft * pixel) {
        list.arrows.push_back(arrow);
        return;
    }
    const Vec2 forward = normalized(arrow.to - arrow.from);
    const Vec2 sideways = perpendicular(forward);
    DrawList::Arrow shaft = arrow;
    shaft.to = seen.to - tail * forward;
    shaft.head = 0.0;
    DrawList::Arrow end = arrow;
    end.from = shaft.to + breakGap * pixel * forward;
    end.to = seen.to;
    list.arrows.push_back(shaft);
    list.arrows.push_back(end);
    const Vec2 slant = pixel * (breakReach * sideways + breakSlope * forward);
    for (const Vec2 middle : {shaft.to, end.from})
        list.lines.push_back({middle - slant, middle + slant, arrow.colour, breakWidth, {}});
}

} // namespace cradle
