// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/raster_painter.h"

#include "views/scene/disc_stamps.h"
#include "views/scene/scene_labels.h"
#include "views/scene/stroke_geometry.h"
#include "views/text_direction.h"

#include <QPainter>
#include <QPainterPath>

#include <optional>

namespace cradle {

namespace {

constexpr double plateOpacity = 0.78;
constexpr double plateRounding = 3.0; ///< px

/// A level or upright line covers whole pixels: as a rectangle it is the same, and needs no
/// smoothing, which takes most of a frame where a grid has many lines.
std::optional<QRectF> rectOf(const QLineF &line, double width)
{
    const double half = 0.5 * width;
    if (line.x1() == line.x2())
        return QRectF(line.x1() - half, line.y1(), width, line.dy()).normalized();
    if (line.y1() == line.y2())
        return QRectF(line.x1(), line.y1() - half, line.dx(), width).normalized();
    return std::nullopt;
}

void paintLines(QPainter &painter, const DrawList &list, const Camera &camera)
{
    const double dpr = painter.device()->devicePixelRatioF();
    for (const DrawList::Line &line : list.lines) {
        const QLineF pixels = pixelLine(line, camera, dpr);
        const bool dashed = line.dash != DrawList::Dash{};
        const auto rect = rectOf(pixels, line.width);
        if (rect && !dashed) {
            painter.fillRect(*rect, line.colour);
            continue;
        }
        QPen pen(line.colour, line.width, Qt::SolidLine, Qt::FlatCap);
        // QPen counts dashes in widths of the pen.
        if (dashed)
            pen.setDashPattern({line.dash.on / line.width, line.dash.off / line.width});
        painter.setPen(pen);
        painter.drawLine(pixels);
    }
}

void paintDiscs(QPainter &painter, const DrawList &list, const Camera &camera)
{
    const QRectF viewport({}, camera.viewport());
    const bool crowded = list.discs.size() >= DiscStamps::crowd;
    DiscStamps stamps;
    for (const DrawList::Disc &disc : list.discs) {
        const QPointF centre = camera.toPixels(disc.centre);
        const double radius = disc.radius * camera.pixelsPerMetre();
        const double reach = radius + disc.outlineWidth;
        if (!viewport.adjusted(-reach, -reach, reach, reach).contains(centre))
            continue;
        if (!crowded || !stamps.stamp(painter, disc, centre, radius))
            paintDisc(painter, disc, centre, radius);
    }
}

/// Shaft and head as one outline, so that they do not show through each other.
QPainterPath arrowPath(const DrawList::Arrow &arrow, const QLineF &line)
{
    const double length = line.length();
    const double head = headLength(arrow, length);
    const double shaft = arrow.width / 2;
    const double barb = head * arrowHeadAspect / 2;
    QPainterPath path;
    path.addPolygon(QPolygonF{{0.0, -shaft},
                              {length - head, -shaft},
                              {length - head, -barb},
                              {length, 0.0},
                              {length - head, barb},
                              {length - head, shaft},
                              {0.0, shaft}});
    path.closeSubpath();
    return QTransform().translate(line.x1(), line.y1()).rotate(-line.angle()).map(path);
}

void paintArrows(QPainter &painter, const DrawList &list, const Camera &camera)
{
    painter.setPen(Qt::NoPen);
    for (const DrawList::Arrow &arrow : list.arrows) {
        const QLineF line(camera.toPixels(arrow.from), camera.toPixels(arrow.to));
        painter.setBrush(arrow.colour);
        painter.drawPath(arrowPath(arrow, line));
    }
}

} // namespace

void paintShapes(QPainter &painter, const DrawList &list, const Camera &camera)
{
    painter.save();
    painter.fillRect(QRectF({}, camera.viewport()), list.background);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLines(painter, list, camera);
    paintDiscs(painter, list, camera);
    paintArrows(painter, list, camera);
    painter.restore();
}

void paintLabels(QPainter &painter, const DrawList &list, const Camera &camera, const QFont &font)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont plain = labelFont(font);
    const QFont strong = labelFont(font, true);
    const QFontMetricsF plainMetrics(plain);
    const QFontMetricsF strongMetrics(strong);
    for (const DrawList::Label &label : list.labels) {
        const QFontMetricsF &metrics = label.strong ? strongMetrics : plainMetrics;
        const QRectF rect = labelRect(label, camera, metrics);
        if (label.plate) {
            QColor plate = list.background;
            plate.setAlphaF(static_cast<float>(plateOpacity) * label.colour.alphaF());
            painter.setPen(Qt::NoPen);
            painter.setBrush(plate);
            painter.drawRoundedRect(rect.adjusted(-2.0, 0.0, 2.0, 0.0), plateRounding,
                                    plateRounding);
        }
        painter.setPen(label.colour);
        painter.setFont(label.strong ? strong : plain);
        painter.setLayoutDirection(directionOf(label.text));
        painter.drawText(QPointF(rect.left(), rect.top() + metrics.ascent()), label.text);
    }
    painter.restore();
}

} // namespace cradle
