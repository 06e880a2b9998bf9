// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/author_windows.h"
#include "app/choices.h"
#include "app/code_desk.h"
#include "app/focus_rounds.h"
#include "app/help_desk.h"
#include "app/keeping_desk.h"
#include "app/opening.h"
#include "app/panes.h"
#include "app/presenter.h"
#include "app/room.h"
#include "app/run_desk.h"
#include "app/scene_desk.h"
#include "app/sounds.h"
#include "app/step_desk.h"
#include "app/verdict_desk.h"
#include "app/work_dialogs.h"
#include "app/work_notices.h"
#include "views/charts/time_window.h"

#include <QMainWindow>

namespace cradle {

/// The window: panes around the scene, joined to the workbench by the desks.
class MainWindow final : public QMainWindow
{
    Q_OBJECT
public:
    /// \param settings  where the layout and the choices of the View menu are kept
    /// \param theme     the choice in force
    MainWindow(Workbench &workbench, QSettings &settings, ThemeChoice theme);

    [[nodiscard]] Workbench &workbench() { return m_workbench; }
    [[nodiscard]] Panes &panes() { return m_panes; }
    [[nodiscard]] TransportBar &transportBar() { return *m_panes.transport; }
    [[nodiscard]] TaskPane &taskPane() { return *m_panes.task; }
    [[nodiscard]] SceneView &scene() { return *m_panes.scene; }
    [[nodiscard]] Inspector &inspector() { return *m_panes.inspector; }
    [[nodiscard]] CodePane &codePane() { return *m_panes.code; }
    [[nodiscard]] VersionsPane &versions() { return *m_panes.versions; }
    [[nodiscard]] NotesPane &notes() { return *m_panes.notes; }
    [[nodiscard]] NoticeBar &notice() { return *m_panes.notice; }
    [[nodiscard]] PhaseChart &phaseChart() { return *m_panes.phase; }
    [[nodiscard]] Announcer &announcer() { return *m_panes.announcer; }

    [[nodiscard]] Sounds &sounds() { return m_sounds; }
    [[nodiscard]] CodeDesk &codeDesk() { return m_codeDesk; }
    [[nodiscard]] Room &room() { return m_room; }
    [[nodiscard]] Choices &choices() { return m_choices; }
    [[nodiscard]] StepDesk &stepDesk() { return m_stepDesk; }
    [[nodiscard]] RunDesk &runDesk() { return m_runDesk; }
    [[nodiscard]] WorkDialogs &dialogs() { return m_dialogs; }
    [[nodiscard]] Opening &opening() { return m_opening; }
    [[nodiscard]] AuthorWindows &authors() { return m_authors; }
    [[nodiscard]] Presenter &presenter() { return m_presenter; }
    [[nodiscard]] HelpDesk &help() { return m_help; }
    [[nodiscard]] FocusRounds &focusRounds() { return m_focus; }

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void placeOnScreen();
    void showTitle();
    void retranslate();

    Workbench &m_workbench;
    QSettings &m_settings;
    RunCurves m_curves;
    TimeWindow m_timeWindow;
    PinnedRuns m_pins;
    Panes m_panes;
    Sounds m_sounds;
    CodeDesk m_codeDesk;
    KeepingDesk m_keeping;
    Room m_room;
    Choices m_choices;
    StepDesk m_stepDesk;
    VerdictDesk m_verdictDesk;
    SceneDesk m_sceneDesk;
    RunDesk m_runDesk;
    WorkNotices m_workNotices;
    WorkDialogs m_dialogs;
    Opening m_opening;
    AuthorWindows m_authors;
    Presenter m_presenter;
    HelpDesk m_help;
    FocusRounds m_focus;
};

} // namespace cradle
