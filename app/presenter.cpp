// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presenter.h"

#include "app/choices.h"
#include "app/presentation.h"
#include "app/room.h"
#include "app/workbench.h"
#include "views/on_change.h"
#include "views/scene/scene_view.h"
#include "views/transport_bar.h"

#include <QAction>
#include <QGuiApplication>
#include <QScreen>
#include <QShortcut>

#include <algorithm>

namespace cradle {

namespace {

constexpr double presentedText = 1.5; ///< of the usual size, at least

/// A key of \p owner's window.
template <typename Slot>
void addKey(const QKeySequence &keys, QWidget *owner, Slot slot)
{
    QObject::connect(new QShortcut(keys, owner), &QShortcut::activated, owner, slot);
}

} // namespace

Presenter::Presenter(Workbench &workbench, SceneView &scene, const TransportBar &transport,
                     Room &room, const Choices &choices, QWidget &window)
    : m_workbench(workbench)
    , m_scene(scene)
    , m_transport(transport)
    , m_room(room)
    , m_choices(choices)
    , m_window(window)
{
}

Presenter::~Presenter()
{
    delete m_secondScene;
}

void Presenter::showFullScreen(bool full)
{
    m_window.setWindowState(m_window.windowState().setFlag(Qt::WindowFullScreen, full));
}

/// What is chosen for it is not kept for later.
void Presenter::present(bool presents)
{
    if (presents == (layer() != nullptr))
        return;
    if (presents) {
        m_before = {m_choices.theme(), textScale(), m_window.isFullScreen()};
        applyTheme(ThemeChoice::HighContrast);
        setTextScale(std::max(presentedText, textScale()));
        m_room.showSceneAlone(true);
        showFullScreen(true);
        cover(m_window);
        if (m_secondScene)
            cover(*m_secondScene);
    } else {
        for (PresentationLayer *each : m_layers)
            delete each;
        m_layers.clear();
        applyTheme(m_before.theme);
        setTextScale(m_before.textScale);
        m_room.showSceneAlone(false);
        showFullScreen(m_before.fullScreen);
    }
    emit presentingChanged();
}

/// Whichever window has the focus, and whichever the others see.
void Presenter::cover(QWidget &window)
{
    auto *cover = new PresentationLayer(&window);
    m_layers.emplace_back(cover);
    addKey(Qt::Key_PageDown, cover, [this] { m_workbench.simulation().seekNextHit(); });
    addKey(Qt::Key_PageUp, cover, [this] { m_workbench.simulation().seekPreviousHit(); });
    addKey(Qt::Key_B, cover, [this] { setBlack(!layer()->isBlack()); });
    addKey(Qt::Key_Escape, cover, [this] { present(false); });
}

void Presenter::setBlack(bool black)
{
    for (PresentationLayer *each : m_layers) {
        if (each)
            each->setBlack(black);
    }
}

PresentationLayer *Presenter::layer() const
{
    return m_layers.empty() ? nullptr : m_layers.front().data();
}

SceneView *Presenter::secondScene() const
{
    return m_secondScene;
}

/// On another screen, where there is one. It follows the same run.
void Presenter::openSceneWindow()
{
    if (!m_secondScene) {
        m_secondScene = new SceneView(m_workbench.document());
        m_secondScene->setAttribute(Qt::WA_DeleteOnClose);
        const auto name = [second = m_secondScene.data()] { second->setWindowTitle(tr("Scene")); };
        name();
        onChange(m_secondScene, {QEvent::LanguageChange}, name);
        m_secondScene->showLike(m_scene);
        addKeys(*m_secondScene);
        for (QScreen *other : QGuiApplication::screens()) {
            if (other == m_window.screen())
                continue;
            m_secondScene->setGeometry(other->geometry());
            m_secondScene->setWindowState(Qt::WindowFullScreen);
        }
        if (layer())
            cover(*m_secondScene);
    }
    m_secondScene->show();
    m_secondScene->raise();
}

/// Menus are of the first window alone.
void Presenter::addKeys(SceneView &second)
{
    second.addActions(m_transport.actions());
    addKey(QKeySequence::ZoomIn, &second, [&second] { second.zoomIn(); });
    addKey(QKeySequence::ZoomOut, &second, [&second] { second.zoomOut(); });
    addKey(Qt::Key_Z, &second, [&second] { second.zoomToHit(); });
    addKey(Qt::CTRL | Qt::Key_0, &second, [&second] { second.fit(); });
    addKey(Qt::Key_F11, &second,
           [&second] { second.setWindowState(second.windowState() ^ Qt::WindowFullScreen); });
}

} // namespace cradle
