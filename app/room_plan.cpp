// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/room_plan.h"

#include "app/panes.h"
#include "views/theme.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>

#include <algorithm>

namespace cradle {

namespace {

// Of the body of the window, between the bars, px or parts of it.
constexpr int lowBody = 660;      ///< a lower one has one chart at a time
constexpr int middlingBody = 880; ///< beside the scene alone, a lower one has inspector or values
constexpr double taskPart = 0.203;
constexpr int leastTask = 268;
constexpr int mostTask = 380;
constexpr double scenePart = 0.345;    ///< of the width, beside a program
constexpr int leastScene = 440;        ///< beside a program: for the values under it
constexpr int leastSceneHeight = 386;  ///< its square is 300 px
constexpr int leastBeside = 434;       ///< right of the scene alone: inspector, charts and values
constexpr double mostBesidePart = 0.5; ///< of what the instructions leave, with large texts
constexpr double sceneHeightPart = 0.655; ///< above the charts
constexpr int valuesHeight = 140;         ///< two circles and their sum

/// The side on which reading begins: the instructions stand there.
Qt::DockWidgetArea beginning()
{
    return QGuiApplication::isRightToLeft() ? Qt::RightDockWidgetArea : Qt::LeftDockWidgetArea;
}

Qt::DockWidgetArea opposite()
{
    return QGuiApplication::isRightToLeft() ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea;
}

} // namespace

RoomPlan::RoomPlan(QMainWindow &window, const Panes &panes)
    : m_window(window)
    , m_panes(panes)
{
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    window.setDockNestingEnabled(true);
    window.setAnimated(false); // nothing moves but the run, whatever the desktop asks for
}

QSize RoomPlan::body() const
{
    const int bars = m_window.menuBar()->sizeHint().height() + m_panes.topBar->sizeHint().height()
                     + m_panes.bottomBar->sizeHint().height();
    return {m_window.width(), std::max(200, m_window.height() - bars)};
}

RoomPlan::Height RoomPlan::height() const
{
    // Large texts make a window low.
    const double room = body().height() / textScale();
    return room < lowBody ? Height::Low : room < middlingBody ? Height::Middling : Height::High;
}

void RoomPlan::put(Mode mode)
{
    m_mode = mode;
    for (QDockWidget *pane : m_panes.docks) {
        pane->setFloating(false);
        m_window.removeDockWidget(pane);
    }
    const bool code = mode == Mode::Code;
    if (code)
        putCode();
    else
        putExplore();
    m_height = height();
    if (m_height == Height::Low)
        m_window.tabifyDockWidget(m_panes.momentumDock, m_panes.energyDock);
    if (code && m_height == Height::Low)
        m_window.tabifyDockWidget(m_panes.energyDock, m_panes.valuesDock);
    if (!code && m_height != Height::High)
        m_window.tabifyDockWidget(m_panes.inspectorDock, m_panes.valuesDock);
    for (QDockWidget *pane : m_panes.docks) {
        const bool ofProgram =
            pane == m_panes.codeDock || pane == m_panes.versionsDock || pane == m_panes.notesDock;
        pane->setVisible(code || !ofProgram);
    }
    m_panes.momentumDock->raise();
    m_panes.workplace(mode)->raise();
    share();
}

/// Instructions | program over values | scene over charts.
void RoomPlan::putCode()
{
    // Qt splits to the right in every language.
    QDockWidget *left = m_panes.taskDock;
    QDockWidget *right = m_panes.codeDock;
    if (QGuiApplication::isRightToLeft())
        std::swap(left, right);
    m_window.addDockWidget(beginning(), left);
    m_window.splitDockWidget(left, right, Qt::Horizontal);
    m_window.splitDockWidget(m_panes.codeDock, m_panes.valuesDock, Qt::Vertical);
    for (QDockWidget *behind : {m_panes.inspectorDock, m_panes.versionsDock, m_panes.notesDock})
        m_window.tabifyDockWidget(m_panes.codeDock, behind);
    m_window.addDockWidget(Qt::BottomDockWidgetArea, m_panes.momentumDock);
    m_window.splitDockWidget(m_panes.momentumDock, m_panes.energyDock, Qt::Vertical);
}

/// Instructions | scene | charts over inspector over values.
void RoomPlan::putExplore()
{
    m_window.addDockWidget(beginning(), m_panes.taskDock);
    for (QDockWidget *pane :
         {m_panes.momentumDock, m_panes.energyDock, m_panes.inspectorDock, m_panes.valuesDock})
        m_window.addDockWidget(opposite(), pane);
    // Their places for when they are asked for.
    for (QDockWidget *pane : {m_panes.codeDock, m_panes.versionsDock, m_panes.notesDock}) {
        m_window.tabifyDockWidget(m_panes.inspectorDock, pane);
        pane->hide();
    }
}

void RoomPlan::fit()
{
    if (m_height == height())
        share();
    else
        put(m_mode);
}

/// Gives every pane its part of the window.
void RoomPlan::share()
{
    const QSize room = body();
    const int task = std::clamp(static_cast<int>(taskPart * room.width()), scaledByText(leastTask),
                                scaledByText(mostTask));
    if (m_mode == Mode::Code)
        shareCode(room, task);
    else
        shareExplore(room, task);
}

void RoomPlan::shareCode(QSize room, int task)
{
    const int values = scaledByText(valuesHeight);
    const int scene = std::max(leastScene, static_cast<int>(scenePart * room.width()));
    const int high = std::max(leastSceneHeight, static_cast<int>(sceneHeightPart * room.height()));
    const int charts = std::max(100, room.height() - high);
    // A window that opens on a small screen may not have the room yet.
    const int code = std::max(1, room.width() - task - scene);
    m_window.resizeDocks({m_panes.taskDock, m_panes.codeDock}, {task, code}, Qt::Horizontal);
    if (m_height == Height::Low) {
        m_window.resizeDocks({m_panes.momentumDock}, {charts}, Qt::Vertical);
        return;
    }
    m_window.resizeDocks({m_panes.codeDock, m_panes.valuesDock}, {room.height() - values, values},
                         Qt::Vertical);
    m_window.resizeDocks({m_panes.momentumDock, m_panes.energyDock}, {charts / 2, charts / 2},
                         Qt::Vertical);
}

void RoomPlan::shareExplore(QSize room, int task)
{
    const int left = room.width() - task;
    const int most = std::max(leastBeside, static_cast<int>(mostBesidePart * left));
    const int beside =
        std::clamp(left - room.height(), std::min(scaledByText(leastBeside), most), most);
    m_window.resizeDocks({m_panes.taskDock, m_panes.momentumDock}, {task, beside}, Qt::Horizontal);
    if (m_height == Height::High) {
        const int values = scaledByText(valuesHeight);
        const int inspector = std::min(scaledByText(420), room.height() / 2);
        const int charts = room.height() - values - inspector;
        m_window.resizeDocks(
            {m_panes.momentumDock, m_panes.energyDock, m_panes.inspectorDock, m_panes.valuesDock},
            {charts / 2, charts / 2, inspector, values}, Qt::Vertical);
        return;
    }
    const bool isLow = m_height == Height::Low;
    const int chart = scaledByText(isLow ? 200 : 160);
    const int inspector = room.height() - (isLow ? 1 : 2) * chart;
    if (isLow)
        m_window.resizeDocks({m_panes.momentumDock, m_panes.inspectorDock}, {chart, inspector},
                             Qt::Vertical);
    else
        m_window.resizeDocks({m_panes.momentumDock, m_panes.energyDock, m_panes.inspectorDock},
                             {chart, chart, inspector}, Qt::Vertical);
}

} // namespace cradle
