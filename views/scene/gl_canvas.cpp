// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/gl_canvas.h"

#include "views/scene/raster_painter.h"

#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>

#include <utility>

namespace cradle {

GlCanvas::GlCanvas(PictureSource source, const QString &shaders, QWidget *parent)
    : QOpenGLWidget(parent)
    , m_source(std::move(source))
    , m_shaders(shaders)
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSamples(0); // the shaders smooth the edges
    setFormat(format);
}

GlCanvas::~GlCanvas()
{
    // The base class destroys the context when there is no GlCanvas any more.
    if (context())
        disconnect(context(), nullptr, this, nullptr);
    release();
}

void GlCanvas::initializeGL()
{
    // A dock that is torn off gets a new context; what belongs to the old one must go with it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::release,
            Qt::UniqueConnection);
    m_painter = std::make_unique<GlPainter>();
    if (const std::optional<QString> reason = m_painter->initialize(m_shaders)) {
        m_painter.reset();
        emit failed(*reason);
    }
}

void GlCanvas::paintGL()
{
    const ScenePicture &picture = m_source();
    if (m_painter)
        m_painter->paint(picture.list, picture.camera, devicePixelRatioF());
    // Not on `this`: in QWidget::grab() that would be the grabbing painter's device.
    const qreal dpr = devicePixelRatioF();
    QOpenGLPaintDevice device(size() * dpr);
    device.setDevicePixelRatio(dpr);
    QPainter painter(&device);
    if (!m_painter)
        paintShapes(painter, picture.list, picture.camera);
    paintOverlay(painter, picture);
}

void GlCanvas::release()
{
    if (!m_painter)
        return;
    makeCurrent();
    m_painter.reset();
    doneCurrent();
}

} // namespace cradle
