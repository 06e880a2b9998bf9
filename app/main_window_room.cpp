// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the panes stand: each mode has an arrangement of its own.
#include "app/main_window.h"

#include "views/fitted_tabs.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QMenuBar>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QSettings>
#include <QTabBar>
#include <QToolBar>

#include <algorithm>

namespace cradle {

namespace {

/// Raised when the panes change so that a kept layout no longer fits.
constexpr int layoutVersion = 4;

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

/// Where one reads from the right the room is mirrored, and its arrangement is another.
QString keyOf(Mode mode)
{
    const QString key =
        mode == Mode::Code ? QStringLiteral("layout/code") : QStringLiteral("layout/explore");
    return QGuiApplication::isRightToLeft() ? key + QStringLiteral("-mirrored") : key;
}

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

MainWindow::Height MainWindow::heightOf(int body)
{
    // Large texts make a window low.
    const double room = body / textScale();
    return room < lowBody ? Height::Low : room < middlingBody ? Height::Middling : Height::High;
}

QDockWidget *MainWindow::dock(const char *name) const
{
    return findChild<QDockWidget *>(QLatin1String(name));
}

QSize MainWindow::body() const
{
    int bars = menuBar()->sizeHint().height();
    for (const char *name : {"transport", "timeline"})
        bars += findChild<QToolBar *>(QLatin1String(name))->sizeHint().height();
    return {width(), std::max(200, height() - bars)};
}

void MainWindow::arrangePanes()
{
    const QScopedValueRollback arranging(m_arranging, true);
    m_arranged = m_workbench.mode();
    const bool code = m_arranged == Mode::Code;
    for (QDockWidget *pane : m_docks) {
        pane->setFloating(false);
        removeDockWidget(pane);
    }
    if (code)
        arrangeCode();
    else
        arrangeExplore();
    m_height = heightOf(body().height());
    if (m_height == Height::Low)
        tabifyDockWidget(dock("momentum"), dock("energy"));
    if (code && m_height == Height::Low)
        tabifyDockWidget(dock("energy"), dock("values"));
    if (!code && m_height != Height::High)
        tabifyDockWidget(dock("inspector"), dock("values"));
    std::vector<const char *> shown{"task", "momentum", "energy", "values", "inspector"};
    if (code)
        shown.insert(shown.end(), {"code", "versions", "notes"});
    for (const char *name : shown)
        dock(name)->show();
    dock("momentum")->raise();
    dock(code ? "code" : "inspector")->raise();
    m_keepsSizes = false;
    shareRoom();
}

/// Instructions | program over values | scene over charts.
void MainWindow::arrangeCode()
{
    const bool mirrored = QGuiApplication::isRightToLeft();
    // Qt splits to the right in every language.
    addDockWidget(beginning(), dock(mirrored ? "code" : "task"));
    splitDockWidget(dock(mirrored ? "code" : "task"), dock(mirrored ? "task" : "code"),
                    Qt::Horizontal);
    splitDockWidget(dock("code"), dock("values"), Qt::Vertical);
    for (const char *name : {"inspector", "versions", "notes"})
        tabifyDockWidget(dock("code"), dock(name));
    addDockWidget(Qt::BottomDockWidgetArea, dock("momentum"));
    splitDockWidget(dock("momentum"), dock("energy"), Qt::Vertical);
}

/// Instructions | scene | charts over inspector over values.
void MainWindow::arrangeExplore()
{
    addDockWidget(beginning(), dock("task"));
    for (const char *name : {"momentum", "energy", "inspector", "values"})
        addDockWidget(opposite(), dock(name));
    // Their places for when they are asked for.
    for (const char *name : {"code", "versions", "notes"}) {
        tabifyDockWidget(dock("inspector"), dock(name));
        dock(name)->hide();
    }
}

/// Gives every pane its part of the window, as long as nobody has moved a border.
void MainWindow::shareRoom()
{
    const QSize room = body();
    const int task = std::clamp(static_cast<int>(taskPart * room.width()), scaledByText(leastTask),
                                scaledByText(mostTask));
    const int values = scaledByText(valuesHeight);
    const bool isLow = m_height == Height::Low;
    if (m_arranged == Mode::Code) {
        const int scene = std::max(leastScene, static_cast<int>(scenePart * room.width()));
        const int high =
            std::max(leastSceneHeight, static_cast<int>(sceneHeightPart * room.height()));
        const int charts = std::max(100, room.height() - high);
        resizeDocks({dock("task"), dock("code")}, {task, room.width() - task - scene},
                    Qt::Horizontal);
        if (isLow) {
            resizeDocks({dock("momentum")}, {charts}, Qt::Vertical);
            return;
        }
        resizeDocks({dock("code"), dock("values")}, {room.height() - values, values}, Qt::Vertical);
        resizeDocks({dock("momentum"), dock("energy")}, {charts / 2, charts / 2}, Qt::Vertical);
        return;
    }
    const int left = room.width() - task;
    const int most = std::max(leastBeside, static_cast<int>(mostBesidePart * left));
    const int beside =
        std::clamp(left - room.height(), std::min(scaledByText(leastBeside), most), most);
    resizeDocks({dock("task"), dock("momentum")}, {task, beside}, Qt::Horizontal);
    if (m_height == Height::High) {
        const int inspector = std::min(scaledByText(420), room.height() / 2);
        const int charts = room.height() - values - inspector;
        resizeDocks({dock("momentum"), dock("energy"), dock("inspector"), dock("values")},
                    {charts / 2, charts / 2, inspector, values}, Qt::Vertical);
        return;
    }
    const int chart = scaledByText(isLow ? 200 : 160);
    const int inspector = room.height() - (isLow ? 1 : 2) * chart;
    if (isLow)
        resizeDocks({dock("momentum"), dock("inspector")}, {chart, inspector}, Qt::Vertical);
    else
        resizeDocks({dock("momentum"), dock("energy"), dock("inspector")},
                    {chart, chart, inspector}, Qt::Vertical);
}

/// What the student has arranged for a mode comes back with it.
void MainWindow::showArrangement()
{
    const Mode mode = m_workbench.mode();
    if (mode == m_arranged)
        return;
    showSceneAlone(false);
    keepArrangement();
    m_arranged = mode;
    restoreArrangement();
}

void MainWindow::keepArrangement()
{
    if (m_keepsSizes)
        m_settings.setValue(keyOf(m_arranged), saveState(layoutVersion));
}

void MainWindow::restoreArrangement()
{
    const QScopedValueRollback arranging(m_arranging, true);
    const QByteArray kept = m_settings.value(keyOf(m_workbench.mode())).toByteArray();
    arrangePanes();
    if (!kept.isEmpty() && restoreState(kept, layoutVersion))
        m_keepsSizes = true;
}

void MainWindow::resetLayout()
{
    m_settings.remove(keyOf(m_workbench.mode()));
    arrangePanes();
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    if (m_keepsSizes || isSceneAlone())
        return;
    if (m_height != heightOf(body().height()))
        arrangePanes();
    else
        shareRoom();
}

/// The borders between the panes are the window's own.
bool MainWindow::event(QEvent *event)
{
    if (event->type() == QEvent::MouseButtonPress
        && isSeparator(static_cast<QMouseEvent *>(event)->position().toPoint()))
        m_keepsSizes = true;
    // Qt makes the tabs of panes and cuts their titles where there is no room.
    if (event->type() == QEvent::ChildPolished) {
        if (auto *tabs = qobject_cast<QTabBar *>(static_cast<QChildEvent *>(event)->child()))
            new FittedTabs(*tabs);
    }
    return QMainWindow::event(event);
}

/// Notes what the student does with a pane.
/// A pane behind another one is still there for Qt: keys must not go into what nobody sees.
void MainWindow::watchPane(QDockWidget *pane)
{
    const auto keep = [this] { m_keepsSizes = m_keepsSizes || !m_arranging; };
    connect(pane, &QDockWidget::dockLocationChanged, this, keep);
    connect(pane, &QDockWidget::topLevelChanged, this, keep);
    // Not toggled(): the first time that the window is shown every pane is, too.
    connect(pane->toggleViewAction(), &QAction::triggered, this, keep);
    connect(pane, &QDockWidget::visibilityChanged, this, [pane](bool seen) {
        if (pane->widget())
            pane->widget()->setEnabled(seen || pane->isHidden());
    });
}

} // namespace cradle
