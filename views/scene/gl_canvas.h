// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/gl_painter.h"
#include "views/scene/raster_canvas.h"

#include <QOpenGLWidget>

namespace cradle {

/// Shows the scene with OpenGL 3.3, its labels with QPainter on top.
class GlCanvas final : public QOpenGLWidget
{
    Q_OBJECT
public:
    /// \param shaders  folder of the shaders
    explicit GlCanvas(PictureSource source, const QString &shaders, QWidget *parent = nullptr);
    ~GlCanvas() override;

signals:
    void failed(const QString &reason); ///< this machine cannot: show the scene otherwise

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void release();

    PictureSource m_source;
    QString m_shaders;
    std::unique_ptr<GlPainter> m_painter; ///< none until initialized
};

} // namespace cradle
