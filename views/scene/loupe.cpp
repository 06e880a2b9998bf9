// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/loupe.h"

#include "views/scene/free_corner.h"
#include "views/scene/hit_parts.h"
#include "views/scene/raster_painter.h"
#include "views/scene/scene_labels.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct LoupeText {
    Q_DECLARE_TR_FUNCTIONS(Loupe)
};

constexpr double share = 0.3;         ///< of the viewport's shorter side
constexpr double smallestSide = 96.0; ///< px
constexpr double largestSide = 240.0; ///< px
constexpr double radiiShown = 5.0;    ///< of the smaller circle, on the shorter side
constexpr double leastGain = 1.5;     ///< times as large as the scene, else it shows nothing new
constexpr double contactRoom = 40.0;  ///< px around the hit that stay free
constexpr double freePrice = 1.0;     ///< of a corner that covers no circle is less

/// On a ground of its own: arrows may end there.
void paintMagnification(QPainter &painter, const QRectF &inside, double magnification,
                        const QFont &font)
{
    constexpr auto place = Qt::AlignTop | Qt::AlignRight;
    const QString text = LoupeText::tr("%1×", "magnification").arg(magnification, 0, 'f', 1);
    const QRectF room = inside.adjusted(6.0, 3.0, -6.0, -3.0);
    painter.setFont(labelFont(font));
    painter.fillRect(painter.boundingRect(room, place, text).adjusted(-2.0, 0.0, 2.0, 0.0),
                     theme().scene);
    painter.setPen(theme().mutedText);
    painter.drawText(room, place, text);
}

} // namespace

std::optional<Camera> cameraAtHit(const SceneMoment &moment, int selected, QSizeF viewport)
{
    const std::vector<ShownHit> hits = shownHits(moment, selected);
    if (hits.empty())
        return std::nullopt;
    const Hit &hit = *hits.front().hit;
    const std::optional<Vec2> contact = contactOf(moment, hit);
    if (!contact)
        return std::nullopt;
    const auto circles = moment.recording.circles(moment.current);
    double radius = circles[static_cast<std::size_t>(hit.a)].radius;
    if (hit.kind == Hit::Kind::Circle)
        radius = std::min(radius, circles[static_cast<std::size_t>(hit.b)].radius);
    Camera camera;
    camera.resize(viewport);
    camera.fit(radiiShown * radius / Camera::extentPerHalfWidth);
    camera.moveBy(*contact);
    return camera;
}

std::optional<Loupe> loupeAt(const SceneMoment &moment, const SceneOptions &options,
                             const SceneLook &look)
{
    const QSizeF viewport = look.camera.viewport();
    const double side =
        std::min(std::floor(share * std::min(viewport.width(), viewport.height())), largestSide);
    if (moment.running || side < smallestSide)
        return std::nullopt;
    const auto camera = cameraAtHit(moment, look.selected, {side, side});
    if (!camera)
        return std::nullopt;
    const double gain = camera->pixelsPerMetre() / look.camera.pixelsPerMetre();
    if (gain < leastGain)
        return std::nullopt;
    std::vector<QRectF> taken = look.reserved;
    const QPointF contact = look.camera.toPixels(camera->centre());
    taken.emplace_back(contact - QPointF(contactRoom, contactRoom),
                       QSizeF(2.0 * contactRoom, 2.0 * contactRoom));
    const FreeCorner corner = freeCorner(moment, look.camera, {side, side}, taken);
    if (corner.price >= freePrice)
        return std::nullopt;
    SceneOptions shown = options;
    shown.trails = false;
    shown.programDrawings = false;
    shown.centreOfMass = false;
    const double row = QFontMetricsF(labelFont(look.font)).height();
    const SceneLook near{.camera = *camera,
                         .font = look.font,
                         .selected = look.selected,
                         .reserved = {QRectF(0.0, 0.0, side, row + 4.0)}};
    return Loupe{corner.frame, gain, buildScene(moment, shown, near), *camera};
}

/// As an image: over OpenGL a QPainter has no smooth edges.
void paintLoupe(QPainter &painter, const Loupe &loupe, const QFont &font)
{
    const double dpr = painter.device()->devicePixelRatioF();
    QImage image((loupe.frame.size() * dpr).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(dpr);
    const QRectF inside({}, loupe.frame.size());
    QPainter near(&image);
    near.setLayoutDirection(Qt::LeftToRight);
    paintShapes(near, loupe.list, loupe.camera);
    paintLabels(near, loupe.list, loupe.camera, font);
    paintMagnification(near, inside, loupe.magnification, font);
    near.setPen(QPen(theme().mutedText, 1.0));
    near.drawRect(inside.adjusted(0.5, 0.5, -0.5, -0.5));
    near.end();
    painter.drawImage(loupe.frame.topLeft(), image);
}

} // namespace cradle
