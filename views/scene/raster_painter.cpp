// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/raster_painter.h"

#include "views/scene/scene_labels.h"
#include "views/scene/stroke_geometry.h"

#include <QPainter>
#include <QPainterPath>

namespace cradle {

namespace {

constexpr double plateOpacity = 0.78;
constexpr double plateRounding = 3.0; ///< px

void paintLines(QPainter &painter, const DrawList &list, const Camera &camera)
{
    const double dpr = painter.device()->devicePixelRatioF();
    for (const DrawList::Line &line : list.lines) {
        QPen pen(line.colour, line.width, Qt::SolidLine, Qt::FlatCap);
        // QPen counts dashes in widths of the pen.
        if (line.dash != DrawList::Dash{})
            pen.setDashPattern({line.dash.on / line.width, line.dash.off / line.width});
        painter.setPen(pen);
        painter.drawLine(pixelLine(line, camera, dpr));
    }
}

void paintDiscs(QPainter &painter, const DrawList &list, const Camera &camera)
{
    const QRectF viewport({}, camera.viewport());
    for (const DrawList::Disc &disc : list.discs) {
        const QPointF centre = camera.toPixels(disc.centre);
        const double radius = disc.radius * camera.pixelsPerMetre();
        const double reach = radius + disc.outlineWidth;
        if (!viewport.adjusted(-reach, -reach, reach, reach).contains(centre))
            continue;
        painter.setPen(disc.outlineWidth > 0.0 ? QPen(disc.outline, disc.outlineWidth)
                                               : QPen(Qt::NoPen));
        painter.setBrush(disc.fill.isValid() ? QBrush(disc.fill) : QBrush(Qt::NoBrush));
        painter.drawEllipse(centre, radius, radius);
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
        painter.drawText(QPointF(rect.left(), rect.top() + metrics.ascent()), label.text);
    }
    painter.restore();
}

} // namespace cradle
