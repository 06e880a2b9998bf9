// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_view.h"

#include "views/scene/ghost.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/raster_painter.h"
#include "views/scene/scene_actions.h"

#include <QGuiApplication>
#include <QPainter>

#include <utility>

namespace cradle {

namespace {

constexpr int noticeMilliseconds = 2000;

bool hasNoScreen()
{
    const QString platform = QGuiApplication::platformName();
    return platform == QLatin1String("offscreen") || platform == QLatin1String("minimal");
}

} // namespace

SceneView::SceneView(PresetDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_editor(document)
    , m_actions(new SceneActions(m_editor, this))
{
    setLayoutDirection(Qt::LeftToRight); // x points to the right in every language
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_camera.fit(document.preset().halfWidth);
    m_noticeTimer.setSingleShot(true);
    connect(&m_noticeTimer, &QTimer::timeout, this, [this] { notice({}); });
    const Simulation &simulation = document.simulation();
    connect(&simulation, &Simulation::frameReady, this, &SceneView::refresh);
    connect(&simulation, &Simulation::runningChanged, this, &SceneView::refresh);
    connect(&simulation, &Simulation::presetChanged, this, &SceneView::followPreset);
    connect(&simulation, &Simulation::restarted, this, [this] { m_notice.clear(); });
    connect(&m_editor, &SceneEditor::noticed, this, &SceneView::notice);
    connect(&m_editor, &SceneEditor::selectionChanged, this, [this](int index) {
        refresh();
        emit selectionChanged(index);
    });
    retranslate();
    setRenderer(Renderer::Automatic);
}

SceneView::~SceneView()
{
    // The canvas asks this view for its picture: it must not live longer than the members.
    delete m_canvas;
}

void SceneView::setRenderer(Renderer renderer)
{
    m_renderer = renderer;
    m_active = renderer;
    m_fallbackReason.clear();
    if (renderer == Renderer::Automatic) {
        const bool gl = !hasNoScreen() && glSupport().usable && !glSupport().software;
        m_active = gl ? Renderer::OpenGl : Renderer::Raster;
    } else if (renderer == Renderer::OpenGl && !glSupport().usable) {
        m_active = Renderer::Raster;
        m_fallbackReason = glSupport().reason;
    }
    installCanvas();
    emit toldToShow();
}

void SceneView::installCanvas()
{
    const PictureSource source = [this]() -> const ScenePicture & { return picture(); };
    const bool focused = hasFocus();
    delete m_canvas;
    if (m_active == Renderer::OpenGl) {
        auto *canvas = new GlCanvas(source, m_shaderFolder, this);
        // Queued: the canvas is being initialized and cannot be deleted just then.
        connect(canvas, &GlCanvas::failed, this, &SceneView::fallBack, Qt::QueuedConnection);
        m_canvas = canvas;
    } else {
        m_canvas = new RasterCanvas(source, this);
    }
    m_canvas->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_canvas->setGeometry(rect());
    m_canvas->show();
    // Qt makes the window anew for the first OpenGL widget in it.
    if (focused)
        setFocus();
    refresh();
}

void SceneView::fallBack(const QString &reason)
{
    if (m_active != Renderer::OpenGl)
        return;
    m_active = Renderer::Raster;
    m_fallbackReason = reason;
    installCanvas();
}

void SceneView::setOptions(const SceneOptions &options)
{
    m_options = options;
    refresh();
    emit toldToShow();
}

void SceneView::setGhost(std::shared_ptr<const Recording> ghost, const QString &label)
{
    m_ghost = std::move(ghost);
    m_ghostLabel = label;
    refresh();
    emit toldToShow();
}

void SceneView::showLike(const SceneView &other)
{
    setRenderer(other.m_renderer);
    take(other);
    connect(&other, &SceneView::toldToShow, this, [this, &other] { take(other); });
}

void SceneView::take(const SceneView &other)
{
    if (m_renderer != other.m_renderer)
        setRenderer(other.m_renderer);
    setOptions(other.m_options);
    setGhost(other.m_ghost, other.m_ghostLabel);
    if (m_follows != other.m_follows)
        followCentreOfMass(other.m_follows);
}

const QList<QAction *> &SceneView::circleActions() const
{
    return m_actions->all();
}

void SceneView::select(int index)
{
    if (index != m_editor.selected())
        m_editor.select(index);
}

void SceneView::refresh()
{
    followCamera();
    m_stale = true;
    if (m_canvas)
        m_canvas->update();
    describe();
}

const ScenePicture &SceneView::picture()
{
    if (!m_stale)
        return m_picture;
    m_stale = false;
    const Simulation &simulation = m_document.simulation();
    const bool grips = simulation.atStart() && m_options.velocities;
    SceneLook look{.camera = m_camera,
                   .font = font(),
                   .selected = m_editor.selected(),
                   .hovered = m_hovered.index,
                   .grips = grips,
                   .refused = m_refused,
                   .selection = m_editor.selection()};
    const SceneMoment seen = moment();
    std::vector<Chip> shown = chips(seen);
    for (const Chip &chip : shown)
        look.reserved.push_back(chipRect(chip, m_camera.viewport(), font()));
    const std::optional<MomentumInset> inset = insetFor(seen, look);
    if (inset)
        look.reserved.push_back(inset->frame);
    const std::optional<Loupe> loupe = loupeFor(seen, look);
    m_picture = {.list = buildScene(seen, m_options, look),
                 .camera = m_camera,
                 .font = font(),
                 .chips = std::move(shown),
                 .inset = inset,
                 .loupe = loupe,
                 .band = m_band,
                 .focusFrame = m_focusFrame};
    return m_picture;
}

std::optional<MomentumInset> SceneView::insetFor(const SceneMoment &seen,
                                                 const SceneLook &look) const
{
    if (!m_options.momenta)
        return std::nullopt;
    return momentumInset(seen, look.camera, look.font, look.reserved);
}

/// Labels stay clear of it.
std::optional<Loupe> SceneView::loupeFor(const SceneMoment &seen, SceneLook &look) const
{
    if (!m_options.loupe || !m_options.hitParts)
        return std::nullopt;
    std::optional<Loupe> loupe = loupeAt(seen, m_options, look);
    if (loupe)
        look.reserved.push_back(loupe->frame);
    return loupe;
}

SceneMoment SceneView::moment() const
{
    const Simulation &simulation = m_document.simulation();
    SceneMoment moment(simulation);
    if (simulation.shadow())
        moment.exact = simulation.shadow()->circles(moment.current);
    if (m_ghost) {
        moment.ghost = circlesAt(*m_ghost, moment.recording.time(moment.current));
        moment.ghostLabel = m_ghostLabel;
    }
    return moment;
}

void SceneView::notice(const QString &text)
{
    m_notice = text;
    if (!text.isEmpty())
        m_noticeTimer.start(noticeMilliseconds);
    refresh();
}

ScenePicture SceneView::plainPicture(QSizeF size) const
{
    ScenePicture picture{.camera = m_camera, .font = font()};
    picture.camera.resize(size);
    SceneLook look{.camera = picture.camera, .font = font()};
    const SceneMoment seen = moment();
    picture.inset = insetFor(seen, look);
    if (picture.inset)
        look.reserved.push_back(picture.inset->frame);
    picture.loupe = loupeFor(seen, look);
    picture.list = buildScene(seen, m_options, look);
    return picture;
}

QImage SceneView::renderToImage(QSize size, qreal dpr) const
{
    QImage image(size * dpr, QImage::Format_RGB32);
    image.setDevicePixelRatio(dpr);
    const ScenePicture picture = plainPicture(size);
    QPainter painter(&image);
    paintShapes(painter, picture.list, picture.camera);
    paintOverlay(painter, picture);
    return image;
}

void SceneView::retranslate()
{
    setAccessibleName(tr("Scene"));
    m_actions->retranslate();
}

void SceneView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    switch (event->type()) {
    case QEvent::LanguageChange:
    case QEvent::PaletteChange:
    case QEvent::StyleChange:
    case QEvent::FontChange:
        refresh();
        break;
    default:
        break;
    }
}

void SceneView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_camera.resize(size());
    if (m_canvas)
        m_canvas->setGeometry(rect());
    refresh();
}

} // namespace cradle
