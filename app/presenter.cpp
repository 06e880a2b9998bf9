// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presenter.h"

#include "app/choices.h"
#include "app/presentation.h"
#include "app/room.h"
#include "app/workbench.h"
#include "views/scene/scene_view.h"

#include <QGuiApplication>
#include <QScreen>
#include <QShortcut>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

constexpr double presentedText = 1.5; ///< of the usual size, at least

} // namespace

Presenter::Presenter(Workbench &workbench, SceneView &scene, Room &room, const Choices &choices,
                     QWidget &window)
    : m_workbench(workbench)
    , m_scene(scene)
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
    if (presents == (m_layer != nullptr))
        return;
    if (presents) {
        m_before = {m_choices.theme(), textScale(), m_window.isFullScreen()};
        applyTheme(ThemeChoice::HighContrast);
        setTextScale(std::max(presentedText, textScale()));
        m_room.showSceneAlone(true);
        showFullScreen(true);
        m_layer = new PresentationLayer(&m_window);
        addKeys();
    } else {
        delete std::exchange(m_layer, nullptr);
        applyTheme(m_before.theme);
        setTextScale(m_before.textScale);
        m_room.showSceneAlone(false);
        showFullScreen(m_before.fullScreen);
    }
    emit presentingChanged();
}

void Presenter::addKeys()
{
    const auto key = [this](int code, auto slot) {
        auto *shortcut = new QShortcut(QKeySequence(code), m_layer);
        connect(shortcut, &QShortcut::activated, this, slot);
    };
    key(Qt::Key_PageDown, [this] { m_workbench.simulation().seekNextHit(); });
    key(Qt::Key_PageUp, [this] { m_workbench.simulation().seekPreviousHit(); });
    key(Qt::Key_B, [this] { m_layer->setBlack(!m_layer->isBlack()); });
    key(Qt::Key_Escape, [this] { present(false); });
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
        m_secondScene->setWindowTitle(tr("Scene"));
        m_secondScene->setRenderer(m_scene.renderer());
        m_secondScene->setOptions(m_scene.options());
        for (QScreen *other : QGuiApplication::screens()) {
            if (other == m_window.screen())
                continue;
            m_secondScene->setGeometry(other->geometry());
            m_secondScene->setWindowState(Qt::WindowFullScreen);
        }
    }
    m_secondScene->show();
    m_secondScene->raise();
}

} // namespace cradle
