// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_view.h"

#include "model/measurements.h"
#include "views/scene/ghost.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/raster_painter.h"

#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

constexpr int noticeMilliseconds = 2000;
constexpr double zoomStep = 1.25;
constexpr std::size_t mostDescribed = 20; ///< circles; a longer list helps nobody

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
{
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
}

void SceneView::setGhost(std::shared_ptr<const Recording> ghost, const QString &label)
{
    m_ghost = std::move(ghost);
    m_ghostLabel = label;
    refresh();
}

void SceneView::refresh()
{
    m_stale = true;
    if (m_canvas)
        m_canvas->update();
    describe();
}

void SceneView::followPreset()
{
    const double halfWidth = m_document.preset().halfWidth;
    if (halfWidth != m_camera.fittedTo())
        m_camera.fit(halfWidth);
    if (m_hovered.index >= m_editor.circleCount())
        m_hovered = {};
    refresh();
}

const ScenePicture &SceneView::picture()
{
    if (!m_stale)
        return m_picture;
    m_stale = false;
    const Simulation &simulation = m_document.simulation();
    const bool grips = simulation.atStart() && m_options.velocities;
    SceneLook look{m_camera, font(), m_editor.selected(), m_hovered.index, grips, m_refused, {}};
    const SceneMoment seen = moment();
    std::vector<Chip> shown = chips(seen);
    for (const Chip &chip : shown)
        look.reserved.push_back(chipRect(chip, m_camera.viewport(), font()));
    m_picture = {.list = buildScene(seen, m_options, look),
                 .camera = m_camera,
                 .font = font(),
                 .chips = std::move(shown),
                 .focusFrame = m_focusFrame};
    return m_picture;
}

SceneMoment SceneView::moment() const
{
    SceneMoment moment(m_document.simulation());
    if (m_ghost)
        moment.ghost = circlesAt(*m_ghost, moment.recording.time(moment.current));
    return moment;
}

QString SceneView::ghostText(const SceneMoment &moment) const
{
    if (moment.ghost.empty())
        return {};
    const auto circles = moment.recording.circles(moment.current);
    const double apart = greatestDistance(circles, moment.ghost);
    return tr("ghost: %1 · %2 m apart")
        .arg(m_ghostLabel, QString::number(apart, apart < 1000.0 ? 'f' : 'g', 3));
}

std::vector<Chip> SceneView::chips(const SceneMoment &moment) const
{
    std::vector<Chip> chips;
    const Recording &recording = moment.recording;
    if (const QString text = ghostText(moment); !text.isEmpty())
        chips.push_back({.text = text});
    if (recording.hasDropped()) {
        const int seconds = static_cast<int>(std::lround(recording.time(recording.first())));
        chips.push_back({.text = seconds < 60 ? tr("first %1 s dropped").arg(seconds)
                                              : tr("first %1 min dropped").arg(seconds / 60),
                         .row = static_cast<int>(chips.size())});
    }
    if (m_editor.circleCount() == 0)
        chips.push_back(
            {Chip::Place::Centre, tr("Add a circle: Edit → Add circle (Ctrl+Shift+N)")});
    if (!m_dragValue.isEmpty())
        chips.push_back({.place = Chip::Place::Pointer,
                         .text = m_dragValue,
                         .warning = m_refused.has_value(),
                         .pointer = m_press.last});
    if (const QString &text = m_refusal.isEmpty() ? m_notice : m_refusal; !text.isEmpty())
        chips.push_back(
            {.place = Chip::Place::Bottom, .text = text, .warning = true, .pointer = m_press.last});
    return chips;
}

void SceneView::notice(const QString &text)
{
    m_notice = text;
    if (!text.isEmpty())
        m_noticeTimer.start(noticeMilliseconds);
    refresh();
}

void SceneView::describe()
{
    const Simulation &simulation = m_document.simulation();
    if (simulation.isRunning())
        return;
    const auto circles = simulation.recording().circles(simulation.current());
    QStringList parts;
    for (std::size_t i = 0; i < std::min(circles.size(), mostDescribed); ++i)
        parts << tr("%1 at %2 m")
                     .arg(circleName(m_document.preset(), static_cast<int>(i)),
                          pairText(circles[i].position));
    if (circles.size() > mostDescribed)
        parts << tr("and %n more", nullptr, static_cast<int>(circles.size() - mostDescribed));
    if (m_editor.selected() >= 0)
        parts << tr("selected: %1").arg(circleName(m_document.preset(), m_editor.selected()));
    if (const QString ghost = ghostText(moment()); !ghost.isEmpty())
        parts << ghost;
    if (!m_notice.isEmpty())
        parts << m_notice;
    const QString text = circles.empty() ? tr("No circles") : parts.join(QStringLiteral("; "));
    if (text != accessibleDescription())
        setAccessibleDescription(text);
}

QImage SceneView::renderToImage(QSize size, qreal dpr) const
{
    QImage image(size * dpr, QImage::Format_RGB32);
    image.setDevicePixelRatio(dpr);
    ScenePicture picture{.camera = m_camera, .font = font()};
    picture.camera.resize(size);
    picture.list = buildScene(moment(), m_options, {.camera = picture.camera, .font = font()});
    QPainter painter(&image);
    paintShapes(painter, picture.list, picture.camera);
    paintOverlay(painter, picture);
    return image;
}

void SceneView::fit()
{
    m_camera.fit(m_document.preset().halfWidth);
    refresh();
}

void SceneView::zoomIn()
{
    m_camera.zoomAbout(m_camera.middle(), zoomStep);
    refresh();
}

void SceneView::zoomOut()
{
    m_camera.zoomAbout(m_camera.middle(), 1.0 / zoomStep);
    refresh();
}

void SceneView::retranslate()
{
    setAccessibleName(tr("Scene"));
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
