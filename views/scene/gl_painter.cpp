// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/gl_painter.h"

#include "views/scene/glx_check.h"
#include "views/scene/stroke_geometry.h"

#include <QCoreApplication>
#include <QFile>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <utility>

namespace cradle {

namespace {

struct GlText {
    Q_DECLARE_TR_FUNCTIONS(GlPainter)
};

/// Floats of an instance: three vec4, whose meaning the vertex shaders tell.
constexpr int vectorsPerInstance = 3;
constexpr int floatsPerInstance = 4 * vectorsPerInstance;
constexpr int cornersOfQuad = 4;

bool isEnough(const QSurfaceFormat &format)
{
    return format.renderableType() == QSurfaceFormat::OpenGL && format.version() >= std::pair(3, 3);
}

QSurfaceFormat wantedFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

void append(std::vector<float> &to, double x, double y, double z, double w)
{
    for (const double value : {x, y, z, w})
        to.push_back(static_cast<float>(value));
}

void append(std::vector<float> &to, const QColor &colour)
{
    if (colour.isValid())
        append(to, colour.redF(), colour.greenF(), colour.blueF(), colour.alphaF());
    else
        append(to, 0.0, 0.0, 0.0, 0.0);
}

void append(std::vector<float> &to, const QLineF &line)
{
    append(to, line.x1(), line.y1(), line.x2(), line.y2());
}

GlSupport probe()
{
    GlSupport support;
    support.reason = GlText::tr("No OpenGL context can be made here");
    if (lacksGlxVisual())
        return support;
    QOffscreenSurface surface;
    surface.setFormat(wantedFormat());
    surface.create();
    QOpenGLContext context;
    context.setFormat(wantedFormat());
    if (!context.create() || !context.makeCurrent(&surface))
        return support;
    support.reason.clear();
    support.renderer = QString::fromUtf8(
        reinterpret_cast<const char *>(context.functions()->glGetString(GL_RENDERER)));
    const QString name = support.renderer.toLower();
    for (const char *software : {"llvmpipe", "softpipe", "swrast", "swiftshader", "gdi generic"})
        support.software = support.software || name.contains(QLatin1String(software));
    support.usable = isEnough(context.format());
    if (!support.usable)
        support.reason = GlText::tr("OpenGL 3.3 is needed, but %1 offers %2.%3")
                             .arg(support.renderer)
                             .arg(context.format().majorVersion())
                             .arg(context.format().minorVersion());
    context.doneCurrent();
    return support;
}

} // namespace

const GlSupport &glSupport()
{
    static const GlSupport support = probe();
    return support;
}

std::optional<QString> GlPainter::initialize(const QString &folder)
{
    const QOpenGLContext *context = QOpenGLContext::currentContext();
    if (!context || !isEnough(context->format()))
        return GlText::tr("OpenGL 3.3 is needed");
    m_discs = std::make_unique<Batch>();
    m_strokes = std::make_unique<Batch>();
    std::optional<QString> fault = build(*m_discs, folder + QStringLiteral("/disc"));
    if (!fault)
        fault = build(*m_strokes, folder + QStringLiteral("/stroke"));
    return fault;
}

std::optional<QString> GlPainter::build(Batch &batch, const QString &path)
{
    const std::pair<QOpenGLShader::ShaderTypeBit, QString> stages[] = {
        {QOpenGLShader::Vertex, path + QStringLiteral(".vert")},
        {QOpenGLShader::Fragment, path + QStringLiteral(".frag")}};
    for (const auto &[type, file] : stages) {
        if (!QFile::exists(file))
            return GlText::tr("The shader %1 is missing").arg(file);
        if (!batch.program.addShaderFromSourceFile(type, file))
            return GlText::tr("The shader %1 does not compile: %2").arg(file, batch.program.log());
    }
    if (!batch.program.link())
        return GlText::tr("The shaders %1 do not link: %2").arg(path, batch.program.log());
    if (!batch.layout.create() || !batch.instances.create())
        return GlText::tr("OpenGL has no memory for the scene");

    const QOpenGLVertexArrayObject::Binder bound(&batch.layout);
    batch.instances.setUsagePattern(QOpenGLBuffer::StreamDraw);
    batch.instances.bind();
    QOpenGLExtraFunctions *gl = QOpenGLContext::currentContext()->extraFunctions();
    for (int i = 0; i < vectorsPerInstance; ++i) {
        const auto location = static_cast<GLuint>(i);
        batch.program.enableAttributeArray(i);
        batch.program.setAttributeBuffer(i, GL_FLOAT, i * 4 * static_cast<int>(sizeof(float)), 4,
                                         floatsPerInstance * static_cast<int>(sizeof(float)));
        gl->glVertexAttribDivisor(location, 1);
    }
    batch.instances.release();
    return std::nullopt;
}

void GlPainter::draw(Batch &batch, const Camera &camera, const std::vector<float> &instances)
{
    if (instances.empty())
        return;
    const QOpenGLVertexArrayObject::Binder bound(&batch.layout);
    batch.instances.bind();
    batch.instances.allocate(instances.data(), static_cast<int>(instances.size() * sizeof(float)));
    batch.program.bind();
    batch.program.setUniformValue("viewport", camera.viewport());
    QOpenGLContext::currentContext()->extraFunctions()->glDrawArraysInstanced(
        GL_TRIANGLE_STRIP, 0, cornersOfQuad,
        static_cast<GLsizei>(instances.size() / floatsPerInstance));
    batch.program.release();
    batch.instances.release();
}

void GlPainter::paint(const DrawList &list, const Camera &camera, double dpr)
{
    QOpenGLFunctions *gl = QOpenGLContext::currentContext()->functions();
    gl->glDisable(GL_DEPTH_TEST);
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glDisable(GL_CULL_FACE);
    gl->glClearColor(list.background.redF(), list.background.greenF(), list.background.blueF(),
                     1.0f);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glEnable(GL_BLEND);
    gl->glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // colours come multiplied with their alpha

    m_scratch.clear();
    for (const DrawList::Line &line : list.lines) {
        append(m_scratch, pixelLine(line, camera, dpr));
        append(m_scratch, line.width, 0.0, line.dash.on, line.dash.off);
        append(m_scratch, line.colour);
    }
    draw(*m_strokes, camera, m_scratch);

    m_scratch.clear();
    for (const DrawList::Disc &disc : list.discs) {
        const QPointF centre = camera.toPixels(disc.centre);
        append(m_scratch, centre.x(), centre.y(), disc.radius * camera.pixelsPerMetre(),
               disc.outlineWidth);
        append(m_scratch, disc.fill);
        append(m_scratch, disc.outline);
    }
    draw(*m_discs, camera, m_scratch);

    m_scratch.clear();
    for (const DrawList::Arrow &arrow : list.arrows) {
        const QLineF line(camera.toPixels(arrow.from), camera.toPixels(arrow.to));
        append(m_scratch, line);
        append(m_scratch, arrow.width, headLength(arrow, line.length()), 0.0, 0.0);
        append(m_scratch, arrow.colour);
    }
    draw(*m_strokes, camera, m_scratch);
    gl->glDisable(GL_BLEND);
}

} // namespace cradle
