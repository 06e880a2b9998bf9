// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/room.h"

#include "app/panes.h"
#include "views/fitted_tabs.h"
#include "views/scene/scene_view.h"

#include <QAction>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QSettings>
#include <QTabBar>

#include <utility>

namespace cradle {

namespace {

/// Raised when the panes change so that a kept layout no longer fits.
constexpr int layoutVersion = 4;

} // namespace

Room::Room(QMainWindow &window, Panes &panes, QSettings &settings, Mode mode)
    : m_window(window)
    , m_panes(panes)
    , m_settings(settings)
    , m_plan(window, panes)
    , m_mode(mode)
{
    for (QDockWidget *pane : panes.docks)
        watch(pane);
    unlockPanes(false);
    window.installEventFilter(this);
}

/// Where one reads from the right the room is mirrored, and its arrangement is another.
QString Room::key() const
{
    const QString key =
        m_mode == Mode::Code ? QStringLiteral("layout/code") : QStringLiteral("layout/explore");
    return QGuiApplication::isRightToLeft() ? key + QStringLiteral("-mirrored") : key;
}

void Room::put()
{
    const QScopedValueRollback arranging(m_arranging, true);
    m_plan.put(m_mode);
    m_keepsSizes = false;
}

void Room::refit()
{
    if (!m_keepsSizes && !isSceneAlone())
        put();
}

void Room::open()
{
    m_arranging = true;
    const QByteArray kept = m_settings.value(key()).toByteArray();
    put();
    m_keepsSizes = !kept.isEmpty() && m_window.restoreState(kept, layoutVersion);
    m_arranging = false;
}

void Room::showMode(Mode mode)
{
    if (mode == m_mode)
        return;
    showSceneAlone(false);
    keep();
    m_mode = mode;
    open();
}

void Room::keep()
{
    if (m_keepsSizes && !isSceneAlone())
        m_settings.setValue(key(), m_window.saveState(layoutVersion));
}

void Room::resetLayout()
{
    m_settings.remove(key());
    put();
}

void Room::unlockPanes(bool unlocked)
{
    m_unlocked = unlocked;
    m_keepsSizes = m_keepsSizes || unlocked;
    for (QDockWidget *dock : m_panes.docks) {
        QWidget *old = dock->titleBarWidget();
        // Without a bar of its own a dock shows the style's, with which it is moved and closed.
        dock->setTitleBarWidget(unlocked ? nullptr : new QWidget(dock));
        delete old;
    }
}

void Room::showSceneAlone(bool alone)
{
    if (alone == isSceneAlone())
        return;
    const QScopedValueRollback arranging(m_arranging, true);
    if (alone) {
        keep();
        std::vector<QDockWidget *> seen;
        for (QDockWidget *pane : m_panes.docks) {
            if (pane->isHidden())
                continue;
            seen.push_back(pane);
            pane->hide();
        }
        m_beforeAlone = std::move(seen);
        m_panes.scene->setFocus();
    } else {
        const std::vector<QDockWidget *> seen = *m_beforeAlone;
        m_beforeAlone.reset();
        for (QDockWidget *pane : seen)
            pane->show();
        for (QDockWidget *front :
             {m_panes.valuesDock, m_panes.momentumDock, m_panes.workplace(m_mode)})
            front->raise();
        refit();
    }
    emit sceneAloneChanged();
}

bool Room::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Resize:
        if (!m_keepsSizes && !isSceneAlone()) {
            const QScopedValueRollback arranging(m_arranging, true);
            m_plan.fit();
        }
        break;
    case QEvent::LayoutDirectionChange:
        open();
        break;
    case QEvent::MouseButtonPress:
        // The borders between the panes are the window's own.
        if (m_window.isSeparator(static_cast<QMouseEvent *>(event)->position().toPoint()))
            m_keepsSizes = true;
        break;
    case QEvent::ChildPolished:
        // Qt makes the tabs of panes and cuts their titles where there is no room.
        if (auto *tabs = qobject_cast<QTabBar *>(static_cast<QChildEvent *>(event)->child()))
            new FittedTabs(*tabs);
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

/// Notes what the student does with a pane.
/// A pane behind another one is still there for Qt: keys must not go into what nobody sees.
void Room::watch(QDockWidget *pane)
{
    const auto note = [this] { m_keepsSizes = m_keepsSizes || !m_arranging; };
    connect(pane, &QDockWidget::dockLocationChanged, this, note);
    connect(pane, &QDockWidget::topLevelChanged, this, note);
    // Not toggled(): the first time that the window is shown every pane is, too.
    connect(pane->toggleViewAction(), &QAction::triggered, this, note);
    connect(pane, &QDockWidget::visibilityChanged, this, [pane](bool seen) {
        if (pane->widget())
            pane->widget()->setEnabled(seen || pane->isHidden());
    });
}

} // namespace cradle
