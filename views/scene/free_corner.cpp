// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/free_corner.h"

#include "views/scene/handles.h"

#include <array>

namespace cradle {

namespace {

constexpr double frameMargin = 8.0; ///< px to the edges of the viewport
constexpr double discRoom = 10.0;   ///< px that the frame keeps from circles, if it can

} // namespace

FreeCorner freeCorner(const SceneMoment &moment, const Camera &camera, QSizeF size,
                      const std::vector<QRectF> &reserved)
{
    const QSizeF viewport = camera.viewport();
    const double right = viewport.width() - frameMargin - size.width();
    const double bottom = viewport.height() - frameMargin - size.height();
    const auto price = [&](const QRectF &frame) {
        double sum = 0.0;
        for (const QRectF &other : reserved)
            sum += frame.intersects(other) ? 100.0 : 0.0;
        for (const Circle &circle : moment.recording.circles(moment.current)) {
            const double reach = circle.radius * camera.pixelsPerMetre() + discRoom;
            const Vec2 tip = arrowTip(circle.position, circle.velocity, moment.preset);
            const QRectF near = frame.adjusted(-reach, -reach, reach, reach);
            sum += near.contains(camera.toPixels(circle.position)) ? 1.0 : 0.0;
            sum += frame.contains(camera.toPixels(tip)) ? 0.5 : 0.0;
        }
        return sum;
    };
    const std::array corners{QPointF(frameMargin, bottom), QPointF(right, bottom),
                             QPointF(frameMargin, frameMargin), QPointF(right, frameMargin)};
    FreeCorner best{QRectF(corners.front(), size), price(QRectF(corners.front(), size))};
    for (const QPointF corner : corners) {
        const QRectF frame(corner, size);
        if (const double sum = price(frame); sum < best.price)
            best = {frame, sum};
    }
    return best;
}

} // namespace cradle
