// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/raster_canvas.h"

#include "views/scene/raster_painter.h"

#include <QPainter>

#include <utility>

namespace cradle {

RasterCanvas::RasterCanvas(PictureSource source, QWidget *parent)
    : QWidget(parent)
    , m_source(std::move(source))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void RasterCanvas::paintEvent(QPaintEvent *)
{
    const ScenePicture &picture = m_source();
    QPainter painter(this);
    paintShapes(painter, picture.list, picture.camera);
    paintOverlay(painter, picture);
}

} // namespace cradle
