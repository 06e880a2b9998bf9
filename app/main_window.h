// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workbench.h"
#include "tasks/runs/run_tables.h"
#include "views/charts/pinned_runs.h"
#include "views/charts/run_curves.h"
#include "views/charts/time_window.h"
#include "views/theme.h"

#include <QMainWindow>
#include <QPointer>

class QSettings;

namespace cradle {

class Announcer;
class AuthorWindow;
class CodeDesk;
class CodePane;
class ConsoleView;
class Inspector;
class KeepingDesk;
class MarkdownView;
class NotesPane;
class HitSounds;
class NoticeBar;
class PhaseChart;
class PresentationLayer;
class SceneView;
class SoundOutput;
class SpeedHistogram;
class TaskPane;
class Timeline;
class TransportBar;
class ValuesPane;
class VersionsPane;
enum class Renderer;
struct SceneOptions;

/// The window: panes around the scene, and the wiring between them and the workbench.
class MainWindow final : public QMainWindow
{
    Q_OBJECT
public:
    /// \param settings  where the layout and the choices of the View menu are kept
    /// \param theme     the choice in force
    MainWindow(Workbench &workbench, QSettings &settings, ThemeChoice theme);
    ~MainWindow() override;

    [[nodiscard]] Workbench &workbench() { return m_workbench; }
    [[nodiscard]] TransportBar &transportBar() { return *m_transport; }
    [[nodiscard]] TaskPane &taskPane() { return *m_taskPane; }
    [[nodiscard]] SceneView &scene() { return *m_scene; }
    [[nodiscard]] Inspector &inspector() { return *m_inspector; }
    [[nodiscard]] CodePane &codePane() { return *m_code; }
    [[nodiscard]] CodeDesk &codeDesk() { return *m_desk; }
    [[nodiscard]] VersionsPane &versions() { return *m_versions; }
    [[nodiscard]] NotesPane &notes() { return *m_notes; }
    [[nodiscard]] Announcer &announcer() { return *m_announcer; }
    [[nodiscard]] HitSounds &hitSounds() { return *m_hitSounds; }
    [[nodiscard]] NoticeBar &notice() { return *m_notice; }
    [[nodiscard]] const std::vector<QDockWidget *> &panes() const { return m_docks; }

    [[nodiscard]] PhaseChart &phaseChart() { return *m_phase; }
    [[nodiscard]] PinnedRuns &pins() { return m_pins; }
    [[nodiscard]] TimeWindow &timeWindow() { return m_timeWindow; }
    /// The window in which a lab is written that was opened last, if one is open.
    [[nodiscard]] AuthorWindow *author() const;
    /// Opens that window with the lab in \p folder. \return what is wrong with it
    std::optional<Error> openAuthor(const QString &folder);
    [[nodiscard]] ThemeChoice themeChoice() const { return m_theme; }
    [[nodiscard]] bool isSceneAlone() const { return m_beforeAlone.has_value(); }
    [[nodiscard]] PresentationLayer *presentation() const { return m_layer; } ///< if it presents
    [[nodiscard]] SceneView *secondScene() const;                             ///< if it is open

public slots:
    void chooseTheme(cradle::ThemeChoice choice);
    void chooseTextSize(int percent); ///< 100 to 200
    void chooseLanguage(const QString &code);
    void chooseRenderer(cradle::Renderer renderer);
    void showExactMotion(bool shown); ///< beside the run
    void pauseAtHits(bool on);
    void slowAtHits(bool on);
    void announceHits(bool on); ///< to screen readers
    void soundHits(bool on);    ///< pitch by mass, loudness by impulse
    void followCentreOfMass(bool on);
    void showInScene(const cradle::SceneOptions &options);
    void unlockPanes(bool unlocked); ///< gives the panes title bars to move them by
    void resetLayout();
    void openLabFolder();
    void openLabFile(); ///< NAME.cradle
    /// Opens the lab in a folder, or unpacks one file into the user's labs and opens that.
    void openLab(const QString &path);
    void openPresetFile();
    void openExample(cradle::Example example);
    void savePresetAs();
    void openReport(); ///< looks back at the work so far, from where a report is written
    void openHandIn();
    void openGrading();     ///< of a class, by the open lab
    void shareWork();       ///< with a git repository elsewhere
    void authorLab();       ///< opens the open lab in a window in which it can be written
    void pinRun();          ///< keeps the run to be compared with later ones
    void startNewRunHere(); ///< from the moment shown; keeps the run so far
    void exportRun(cradle::RunTable table);
    void resetCharts(); ///< ends their zoom
    void showAbout();
    void showShortcuts();
    /// Moves the keyboard's focus to the next pane that is seen. \param direction 1 or −1
    void focusNextPane(int direction);
    void focusCode(); ///< in Code mode, the editor
    void showFullScreen(bool full);
    void showSceneAlone(bool alone); ///< without panes, as for a projector
    /// Larger texts, high contrast, the scene alone on the full screen, keys of presenters (Page Up
    /// and Down from hit to hit, B for black, Esc ends it), and a trail behind the pointer.
    void present(bool presents);
    void showTour();        ///< of this window
    void showCSharpSheet(); ///< what is different in Lua
    void openSceneWindow(); ///< the same scene once more, on another screen if there is one

signals:
    void showingChanged(); ///< isSceneAlone() or isPresenting()

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool event(QEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void makePanes();
    QDockWidget *addPane(QWidget *widget, const QString &name, Qt::DockWidgetArea area);
    void wireWorkbench();
    void wireViews();
    void wireCharts();
    [[nodiscard]] RunSource runSource(); ///< of the run that goes on
    enum class Height { Low, Middling, High };
    [[nodiscard]] static Height heightOf(int body);          ///< px
    void arrangePanes();                                     ///< as the mode has them at first
    [[nodiscard]] std::vector<QWidget *> focusRound() const; ///< by F6
    [[nodiscard]] std::vector<QWidget *> tabRound() const;
    void arrangeCode();
    void arrangeExplore();
    void shareRoom();
    void showArrangement();
    void keepArrangement();
    void restoreArrangement();
    void watchPane(QDockWidget *pane);
    [[nodiscard]] QDockWidget *dock(const char *name) const;
    [[nodiscard]] QSize body() const; ///< px between the bars
    void retranslate();
    void restoreChoices();
    void showTask();
    void showInstructions();
    void showProgress();
    void showLooseScene();
    void showReport();
    void announceVerdict();
    void play(std::vector<float> samples); ///< a sound
    void showVisit(bool visiting);
    void showMode();
    void chooseMode(int index);
    void titleTabs();
    void showGhost();
    void showPause(const cradle::StudentScript::Pause &pause);
    void showLine(int line); ///< of the program
    void report(const Error &error);
    void wireKeeping();
    void showTaskNotice();
    void showHolder();
    void askNameOnce();
    void giveName();
    void showSetAside(const QString &name, const QString &kept);
    void askNumber();
    void lookBack(bool finished);
    [[nodiscard]] bool hasWork();
    void reportUnsaved(const Error &error);
    [[nodiscard]] bool mayClose();

    Workbench &m_workbench;
    QSettings &m_settings;
    RunCurves m_curves;
    TimeWindow m_timeWindow;
    PinnedRuns m_pins;
    TransportBar *m_transport = nullptr;
    TaskPane *m_taskPane = nullptr;
    SceneView *m_scene = nullptr;
    Inspector *m_inspector = nullptr;
    CodePane *m_code = nullptr;
    CodeDesk *m_desk = nullptr;
    VersionsPane *m_versions = nullptr;
    NotesPane *m_notes = nullptr;
    KeepingDesk *m_keeping = nullptr;
    ConsoleView *m_console = nullptr;
    QWidget *m_plots = nullptr;
    SpeedHistogram *m_speeds = nullptr;
    PhaseChart *m_phase = nullptr;
    NoticeBar *m_notice = nullptr;
    Announcer *m_announcer = nullptr;
    HitSounds *m_hitSounds = nullptr;
    SoundOutput *m_soundOutput = nullptr; ///< once something sounded
    Timeline *m_timeline = nullptr;
    ValuesPane *m_values = nullptr;
    std::vector<QDockWidget *> m_docks;
    QList<QPointer<AuthorWindow>> m_authors; ///< one for each lab; the last that was opened last
    QPointer<SceneView> m_secondScene;
    QPointer<MarkdownView> m_sheet;
    PresentationLayer *m_layer = nullptr;                    ///< while it presents
    std::optional<std::vector<QDockWidget *>> m_beforeAlone; ///< the panes that were seen
    struct {
        ThemeChoice theme = ThemeChoice::System;
        double textScale = 1.0;
        bool fullScreen = false;
    } m_beforePresenting;
    ThemeChoice m_theme = ThemeChoice::System;
    QString m_unsavedWarning;        ///< that the program could not be saved
    std::optional<bool> m_saidFault; ///< of a scene of a check, that this is the moment
    bool m_unlocked = false;
    Mode m_arranged = Mode::Explore; ///< whose arrangement is shown
    bool m_keepsSizes = false;       ///< the student has moved a border or a pane
    bool m_arranging = true;         ///< what happens to panes is not the student's doing
    Height m_height = Height::High;  ///< that it was arranged for
};

} // namespace cradle
