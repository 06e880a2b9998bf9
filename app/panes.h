// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <array>
#include <vector>

QT_BEGIN_NAMESPACE
class QDockWidget;
class QMainWindow;
class QSettings;
class QToolBar;
QT_END_NAMESPACE

namespace cradle {

class Announcer;
class CodePane;
class ConsoleView;
class EnergyChart;
class Inspector;
class MomentumChart;
class NotesPane;
class NoticeBar;
class ChartPane;
class PhaseChart;
class PlotPane;
class PinnedRuns;
class PlotsChart;
class RunCurves;
class SceneView;
class SpeedHistogram;
class TaskPane;
class TimeWindow;
class Timeline;
class TransportBar;
class ValuesPane;
class VersionsPane;
class Workbench;
enum class Mode;

/// Every part of the window, by its name. They lie in the window, and go before what they show.
struct Panes {
    Q_DECLARE_TR_FUNCTIONS(Panes)
    Q_DISABLE_COPY_MOVE(Panes)
public:
    /// Fills \p window; it, and all that the panes show, outlives them.
    /// \param time, pins  shared by the charts
    Panes(QMainWindow &window, Workbench &workbench, RunCurves &curves, TimeWindow &time,
          PinnedRuns &pins);
    ~Panes();

    /// Titles of docks and tabs, in the language in force.
    void retranslate();
    /// The dock in which a student works in that mode: the program or the inspector.
    [[nodiscard]] QDockWidget *workplace(Mode mode) const;
    /// Brings the program to the front, with the keyboard's focus; at \p line, if there is one.
    void showCode(int line = 0);
    [[nodiscard]] std::array<ChartPane *, 3> charts() const; ///< those over time
    [[nodiscard]] std::array<PlotPane *, 4> plotPanes() const;

    QMainWindow &window;
    TransportBar *transport;
    NoticeBar *notice;
    QToolBar *topBar; ///< holds both
    Timeline *timeline;
    QToolBar *bottomBar; ///< holds it
    Announcer *announcer;
    SceneView *scene; ///< in the middle; all that follows lies in docks
    TaskPane *task;
    CodePane *code;
    Inspector *inspector;
    VersionsPane *versions;
    NotesPane *notes;
    MomentumChart *momentum;
    EnergyChart *energy;
    ValuesPane *values;
    ConsoleView *console; ///< a tab of values, as what follows
    PlotsChart *plots;
    SpeedHistogram *speeds;
    PhaseChart *phase;

    std::vector<QDockWidget *> docks; ///< all that follow, as the menu lists them
    QDockWidget *taskDock;
    QDockWidget *codeDock;
    QDockWidget *inspectorDock;
    QDockWidget *versionsDock;
    QDockWidget *notesDock;
    QDockWidget *momentumDock;
    QDockWidget *energyDock;
    QDockWidget *valuesDock;

private:
    [[nodiscard]] QDockWidget *addDock(QWidget *widget, const char *name, Qt::DockWidgetArea area);
};

} // namespace cradle
