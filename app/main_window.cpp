// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "app/main_menu.h"
#include "app/workbench.h"
#include "views/accessible_roles.h"
#include "views/scene/scene_view.h"

#include <QCloseEvent>
#include <QScreen>
#include <QSettings>

namespace cradle {

namespace {

constexpr QSize firstSize{1440, 900}; ///< px

/// Only what is made after they are installed has these roles.
Panes panesWithRoles(QMainWindow &window, Workbench &workbench, RunCurves &curves, TimeWindow &time,
                     PinnedRuns &pins)
{
    installAccessibleRoles();
    return {window, workbench, curves, time, pins};
}

} // namespace

MainWindow::MainWindow(Workbench &workbench, QSettings &settings, ThemeChoice theme)
    : m_workbench(workbench)
    , m_settings(settings)
    , m_curves(workbench.simulation())
    , m_panes(panesWithRoles(*this, workbench, m_curves, m_timeWindow, m_pins))
    , m_sounds(workbench.simulation(), *m_panes.notice)
    , m_codeDesk(workbench, *m_panes.code, settings)
    , m_keeping(workbench, *m_panes.versions, *m_panes.notes)
    , m_room(*this, m_panes, settings, workbench.mode())
    , m_choices(workbench, m_panes, m_room, m_sounds, settings, theme)
    , m_stepDesk(workbench, m_panes, m_room, settings)
    , m_verdictDesk(workbench, m_panes, m_codeDesk)
    , m_sceneDesk(workbench, m_panes)
    , m_runDesk(workbench, m_panes, m_curves, m_pins, m_sounds)
    , m_workNotices(workbench, *m_panes.notice, settings, *this)
    , m_dialogs(workbench, m_keeping, *m_panes.notice, *this)
    , m_opening(workbench, *m_panes.notice, *this)
    , m_authors(workbench, *m_panes.notice, settings, *this)
    , m_presenter(workbench, *m_panes.scene, *m_panes.transport, m_room, m_choices, *this)
    , m_help(workbench, m_panes, m_room, *this)
    , m_focus(*this, m_panes)
{
    connect(&workbench, &Workbench::taskChanged, this, &MainWindow::showTitle);
    connect(&m_workNotices, &WorkNotices::tourRequested, &m_help, &HelpDesk::showTour);
    retranslate();
    placeOnScreen();
    m_room.open();
    m_panes.scene->setFocus();
}

/// No larger than the screen, with room for its window's frame.
void MainWindow::placeOnScreen()
{
    const QSize room = screen()->availableGeometry().size() - QSize(0, 32);
    resize(firstSize.boundedTo(room));
    restoreGeometry(m_settings.value(QStringLiteral("geometry")).toByteArray());
}

void MainWindow::showTitle()
{
    if (m_workbench.task())
        setWindowTitle(m_workbench.lab().title);
    else if (const auto example = m_workbench.example())
        setWindowTitle(titleOf(*example));
    else
        setWindowTitle(m_workbench.document().preset().name);
}

void MainWindow::retranslate()
{
    showTitle();
    m_panes.retranslate();
    m_sceneDesk.showGhost();
    fillMenuBar(*this);
}

void MainWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    m_keeping.keepNote();
    if (!m_authors.closeAll() || !m_workNotices.mayClose()) {
        event->ignore();
        return;
    }
    m_settings.setValue(QStringLiteral("geometry"), saveGeometry());
    m_room.keep();
    m_workbench.progress().save();
    event->accept();
}

/// Qt goes in the order in which controls were made, so that a card that is made later comes last.
bool MainWindow::focusNextPrevChild(bool next)
{
    return m_focus.focusNextControl(next) || QMainWindow::focusNextPrevChild(next);
}

} // namespace cradle
