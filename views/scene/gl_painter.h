// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/camera.h"
#include "views/scene/draw_list.h"

#include <QOpenGLBuffer>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <memory>
#include <optional>

namespace cradle {

/// Draws lines, discs and arrows of a DrawList with OpenGL 3.3 core: one instanced draw call for
/// each kind, edges smoothed in the fragment shader. Labels are not its matter. All functions need
/// the context current, the destructor too if initialize() succeeded.
class GlPainter
{
public:
    /// Compiles the shaders in \p folder (disc and stroke, .vert and .frag).
    /// \return the reason if this context cannot draw the scene
    [[nodiscard]] std::optional<QString>
    initialize(const QString &folder = QStringLiteral(":/shaders"));

    /// Draws into the current framebuffer, which is camera.viewport() times \p dpr large.
    void paint(const DrawList &list, const Camera &camera, double dpr);

private:
    /// A program with the instances that it draws.
    struct Batch {
        QOpenGLShaderProgram program;
        QOpenGLVertexArrayObject layout;
        QOpenGLBuffer instances{QOpenGLBuffer::VertexBuffer};
    };

    std::optional<QString> build(Batch &batch, const QString &path);
    void draw(Batch &batch, const Camera &camera, const std::vector<float> &instances);

    // Made anew by initialize(): a failed try leaves nothing behind.
    std::unique_ptr<Batch> m_discs;
    std::unique_ptr<Batch> m_strokes;
    std::vector<float> m_scratch; ///< of the batch that is being drawn
};

/// What OpenGL this machine has, found out once by making a context.
struct GlSupport {
    bool usable = false;   ///< 3.3 core can be had
    bool software = false; ///< drawn by the processor (llvmpipe and the like)
    QString renderer{};    ///< its own name
    QString reason{};      ///< why it is not usable
};

[[nodiscard]] const GlSupport &glSupport();

} // namespace cradle
