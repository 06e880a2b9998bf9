// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/figure.h"

#include "views/scene/raster_painter.h"
#include "views/scene/scene_view.h"
#include "views/theme_override.h"

#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

namespace cradle {

namespace {

constexpr QSize size{480, 480}; ///< px; a text shows it smaller where it must

} // namespace

QByteArray figureOf(const SceneView &scene)
{
    const ThemeOverride light(Theme::lightTheme());
    const ScenePicture picture = scene.plainPicture(size);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setSize(size);
    svg.setViewBox(QRect({}, size));
    svg.setTitle(QStringLiteral("Scene"));
    QPainter painter(&svg);
    painter.setRenderHint(QPainter::Antialiasing);
    paintShapes(painter, picture.list, picture.camera);
    paintLabels(painter, picture.list, picture.camera, picture.font);
    painter.end();
    return buffer.data();
}

} // namespace cradle
