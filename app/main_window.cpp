// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "app/code_desk.h"
#include "app/language.h"
#include "app/main_menu.h"
#include "app/notice_bar.h"
#include "model/preset_json.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/plots_chart.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/console_view.h"
#include "views/inspector/inspector.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"
#include "views/values_table.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QToolBar>
#include <QVBoxLayout>

namespace cradle {

namespace {

/// Raised when the panes change so that a kept layout no longer fits.
constexpr int layoutVersion = 2;
constexpr QSize firstSize{1440, 900}; ///< px

QToolBar *fixedBar(QMainWindow *window, Qt::ToolBarArea area, QWidget *content, const QString &name)
{
    auto *bar = new QToolBar(window);
    bar->setObjectName(name);
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setEnabled(false);
    bar->addWidget(content);
    window->addToolBar(area, bar);
    return bar;
}

} // namespace

MainWindow::MainWindow(Workbench &workbench, QSettings &settings, ThemeChoice theme)
    : m_workbench(workbench)
    , m_settings(settings)
    , m_curves(workbench.simulation())
    , m_theme(theme)
{
    makePanes();
    wireWorkbench();
    wireViews();
    m_scene->setRenderer(
        static_cast<Renderer>(settings.value(QStringLiteral("renderer"), 0).toInt()));
    retranslate();
    // No larger than the screen, with room for its window's frame.
    const QSize room = screen()->availableGeometry().size() - QSize(0, 32);
    resize(firstSize.boundedTo(room));
    arrangePanes();
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("layout")).toByteArray(), layoutVersion);
    m_scene->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::makePanes()
{
    Simulation &simulation = m_workbench.simulation();
    PresetDocument &document = m_workbench.document();

    m_transport = new TransportBar(simulation, this);
    fixedBar(this, Qt::TopToolBarArea, m_transport, QStringLiteral("transport"));
    m_timeline = new Timeline(simulation, this);
    fixedBar(this, Qt::BottomToolBarArea, m_timeline, QStringLiteral("timeline"));

    auto *centre = new QWidget(this);
    m_notice = new NoticeBar(centre);
    m_scene = new SceneView(document, centre);
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_notice);
    column->addWidget(m_scene, 1);
    setCentralWidget(centre);

    m_taskPane = new TaskPane(this);
    m_inspector = new Inspector(document, this);
    m_code = new CodePane(this);
    m_code->setTitle({}); // its tab tells it
    m_desk = new CodeDesk(m_workbench, *m_code, m_settings, this);
    m_values = new ValuesPane(simulation, this);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    addPane(m_taskPane, QStringLiteral("task"), Qt::LeftDockWidgetArea);
    setTabPosition(Qt::BottomDockWidgetArea, QTabWidget::North);
    addPane(m_code, QStringLiteral("code"), Qt::BottomDockWidgetArea);
    addPane(m_inspector, QStringLiteral("inspector"), Qt::BottomDockWidgetArea);
    addPane(new MomentumChart(simulation, m_curves, this), QStringLiteral("momentum"),
            Qt::RightDockWidgetArea);
    addPane(new EnergyChart(simulation, m_curves, this), QStringLiteral("energy"),
            Qt::RightDockWidgetArea);
    addPane(m_values, QStringLiteral("values"), Qt::RightDockWidgetArea);
    m_console = new ConsoleView(simulation, this);
    m_values->addTab(m_console, m_console->windowTitle());
    auto *plots = new PlotsChart(simulation, m_curves, this);
    m_plots = plots;
    m_values->addTab(plots, plots->windowTitle());
    unlockPanes(false);
}

QDockWidget *MainWindow::addPane(QWidget *widget, const QString &name, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(this);
    dock->setObjectName(name);
    dock->setWidget(widget);
    addDockWidget(area, dock);
    m_docks.push_back(dock);
    return dock;
}

void MainWindow::arrangePanes()
{
    const auto dock = [this](const char *name) {
        return findChild<QDockWidget *>(QLatin1String(name));
    };
    for (QDockWidget *pane : m_docks) {
        pane->setFloating(false);
        pane->show();
    }
    addDockWidget(Qt::LeftDockWidgetArea, dock("task"));
    addDockWidget(Qt::BottomDockWidgetArea, dock("code"));
    tabifyDockWidget(dock("code"), dock("inspector"));
    for (const char *name : {"momentum", "energy", "values"})
        addDockWidget(Qt::RightDockWidgetArea, dock(name));
    resizeDocks({dock("task"), dock("momentum")}, {332, 356}, Qt::Horizontal);
    resizeDocks({dock("code"), dock("inspector")}, {280, 280}, Qt::Vertical);
    resizeDocks({dock("momentum"), dock("energy"), dock("values")}, {246, 246, 276}, Qt::Vertical);
    showMode();
}

void MainWindow::wireWorkbench()
{
    Workbench *bench = &m_workbench;
    connect(bench, &Workbench::labChanged, this, [this] { m_taskPane->setLab(m_workbench.lab()); });
    connect(bench, &Workbench::taskChanged, this, &MainWindow::showTask);
    connect(bench, &Workbench::progressChanged, this,
            [this] { m_taskPane->setProgress(m_workbench.passed(), m_workbench.current()); });
    connect(bench, &Workbench::reportChanged, this, &MainWindow::showReport);
    connect(bench, &Workbench::reportStale, this, [this] { m_taskPane->setStale(true); });
    connect(bench, &Workbench::checkStarted, this, [this] {
        m_transport->setChecking(true);
        m_taskPane->setChecking(true);
    });
    connect(bench, &Workbench::checkProgressed, this, [this](int done, int total) {
        m_transport->setCheckProgress(total > 0 ? double(done) / total : 0.0);
        m_taskPane->setChecking(true, done, total);
    });
    connect(bench, &Workbench::checkEnded, this, [this] {
        m_transport->setChecking(false);
        m_taskPane->setReport(m_workbench.report());
    });
    connect(bench, &Workbench::failed, this, &MainWindow::report);
    connect(bench, &Workbench::modeChanged, this, &MainWindow::showMode);
    connect(bench, &Workbench::ghostChanged, this, &MainWindow::showGhost);
    connect(&bench->code(), &CodeSession::paused, this, &MainWindow::showPause);
    connect(&bench->code(), &CodeSession::steppingEnded, this, &MainWindow::showGhost);
    connect(m_transport, &TransportBar::modeChosen, this, &MainWindow::chooseMode);
    connect(m_transport, &TransportBar::checkRequested, bench, &Workbench::check);
    connect(m_transport, &TransportBar::checkCancelled, bench, &Workbench::cancelCheck);
    connect(m_taskPane, &TaskPane::stepChosen, bench, &Workbench::openTaskAt);
    connect(m_taskPane, &TaskPane::hintOpened, bench, &Workbench::setHintsOpened);
    connect(m_taskPane, &TaskPane::showMoment, bench, &Workbench::showMoment);
    connect(m_taskPane, &TaskPane::nextStepRequested, bench, &Workbench::openNextTask);
    connect(m_taskPane, &TaskPane::lineRequested, this, &MainWindow::showLine);
    connect(m_taskPane, &TaskPane::solutionRequested, m_code, &CodePane::solutionRequested);
}

void MainWindow::wireViews()
{
    Simulation *simulation = &m_workbench.simulation();
    PresetDocument *document = &m_workbench.document();
    connect(m_scene, &SceneView::selectionChanged, m_inspector, &Inspector::select);
    connect(m_inspector, &Inspector::selectionChanged, m_scene, &SceneView::select);
    connect(document, &PresetDocument::visitingChanged, this, &MainWindow::showVisit);
    connect(m_notice, &NoticeBar::actionTriggered, document, &PresetDocument::leave);
    for (ChartPane *chart : findChildren<ChartPane *>()) {
        connect(chart, &ChartPane::seekRequested, simulation, [simulation](double time) {
            simulation->seek(simulation->recording().indexAt(time));
        });
    }
    connect(m_values, &ValuesPane::seekRequested, simulation, &Simulation::seek);
    connect(m_console, &ConsoleView::seekRequested, simulation, &Simulation::seek);
    connect(m_console, &ConsoleView::lineActivated, this, &MainWindow::showLine);
    connect(m_console, &ConsoleView::errorShown, this,
            [this](bool shown) { m_values->markTab(m_console, shown); });
    connect(simulation, &Simulation::noHitFound, this,
            [this] { m_notice->showNotice(tr("Nothing hits anything within the next minute.")); });
}

void MainWindow::showTask()
{
    const Task *task = m_workbench.task();
    m_transport->checkAction()->setEnabled(task != nullptr);
    m_taskPane->setProgress(m_workbench.passed(), m_workbench.current());
    if (task) {
        m_taskPane->showTask(taskFor(m_workbench.mode(), *task), m_workbench.hintsOpened());
    } else {
        Task scene;
        scene.title = m_workbench.document().preset().name;
        scene.instructions =
            tr("# %1\n\nThis scene belongs to no step: play with it. Choose a step "
               "above to go back to the lab.")
                .arg(scene.title.isEmpty() ? tr("A scene of your own") : scene.title);
        m_taskPane->showTask(scene, 0);
    }
    m_notice->hide();
    if (m_workbench.isFirstStart() && m_workbench.current() == 0) {
        m_notice->showNotice(
            m_workbench.mode() == Mode::Code
                ? tr("Read the step on the left, write your program below the scene, press Run to "
                     "watch, and Check when you are done.")
                : tr("Read the step on the left, set the values below the scene, press Run to "
                     "watch, and Check when you are done."));
    }
    retranslate();
}

/// The pane that the student works with comes to the front; the texts follow.
void MainWindow::showMode()
{
    const bool code = m_workbench.mode() == Mode::Code;
    auto *codeDock = findChild<QDockWidget *>(QStringLiteral("code"));
    auto *inspectorDock = findChild<QDockWidget *>(QStringLiteral("inspector"));
    const bool hasStep = m_workbench.task() != nullptr;
    m_transport->setModes(hasStep ? QStringList{tr("Explore"), tr("Code")} : QStringList(),
                          code ? 1 : 0);
    codeDock->setVisible(code);
    (code ? codeDock : inspectorDock)->raise();
    if (const Task *task = m_workbench.task())
        m_taskPane->showTask(taskFor(m_workbench.mode(), *task), m_workbench.hintsOpened());
}

void MainWindow::chooseMode(int index)
{
    const Mode mode = index == 1 ? Mode::Code : Mode::Explore;
    m_settings.setValue(QStringLiteral("mode"), index);
    m_workbench.setMode(mode);
}

void MainWindow::showGhost()
{
    m_scene->setGhost(m_workbench.ghost(), tr("reference"));
}

/// In the middle of an update the circles are where the program has put them so far.
void MainWindow::showPause(const StudentScript::Pause &pause)
{
    auto soFar = std::make_shared<Recording>();
    soFar->append({.time = m_workbench.simulation().time(), .step = 0, .circles = pause.circles});
    m_scene->setGhost(soFar, tr("so far in this step"));
}

void MainWindow::showLine(int line)
{
    findChild<QDockWidget *>(QStringLiteral("code"))->raise();
    m_code->editor().goToLine(line);
    m_code->editor().setFocus();
}

void MainWindow::titleTabs()
{
    m_values->setTabTitle(m_console, m_console->windowTitle());
    m_values->setTabTitle(m_plots, m_plots->windowTitle());
}

void MainWindow::showReport()
{
    m_taskPane->setOffersSolution(m_workbench.mode() == Mode::Code
                                  && m_workbench.mayShowSolution());
    m_taskPane->setReport(m_workbench.report());
    m_desk->showReport();
    std::vector<Timeline::Mark> marks;
    const Preset &own = m_workbench.document().own();
    if (m_workbench.report()) {
        for (const CheckOutcome &check : m_workbench.report()->checks) {
            if (!check.passed && check.scene == own && !check.pinned)
                marks.push_back({.time = static_cast<double>(check.step) * own.timestep,
                                 .label = tr("Not yet: %1").arg(check.title)});
        }
    }
    m_timeline->setMarks(marks);
}

void MainWindow::showVisit(bool visiting)
{
    if (visiting)
        m_notice->showNotice(tr("This is a scene of the check, at the moment where it went wrong."),
                             tr("Back to my scene"));
    else
        m_notice->hide();
}

void MainWindow::report(const Error &error)
{
    m_notice->showNotice(error.toString());
}

void MainWindow::chooseTheme(ThemeChoice choice)
{
    m_theme = choice;
    m_settings.setValue(QStringLiteral("theme"), static_cast<int>(choice));
    applyTheme(choice);
}

void MainWindow::chooseLanguage(const QString &code)
{
    m_settings.setValue(QStringLiteral("language"), code);
    setLanguage(code);
    m_workbench.setLanguage(code);
}

void MainWindow::chooseRenderer(Renderer renderer)
{
    m_settings.setValue(QStringLiteral("renderer"), static_cast<int>(renderer));
    m_scene->setRenderer(renderer);
    if (!m_scene->fallbackReason().isEmpty())
        m_notice->showNotice(m_scene->fallbackReason());
}

void MainWindow::unlockPanes(bool unlocked)
{
    m_unlocked = unlocked;
    for (QDockWidget *dock : m_docks) {
        QWidget *old = dock->titleBarWidget();
        // Without a bar of its own a dock shows the style's, with which it is moved and closed.
        dock->setTitleBarWidget(unlocked ? nullptr : new QWidget(dock));
        delete old;
    }
}

void MainWindow::resetLayout()
{
    arrangePanes();
}

void MainWindow::openLabFolder()
{
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a lab's folder"));
    if (folder.isEmpty())
        return;
    if (const auto error = m_workbench.openLab(folder, currentLanguage()))
        report(*error);
}

void MainWindow::openPresetFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a scene"), {},
                                                      tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return;
    if (const auto error = m_workbench.openPreset(path))
        report(*error);
}

void MainWindow::savePresetAs()
{
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the scene"), QStringLiteral("scene.json"),
                                     tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return;
    if (const auto error = savePreset(m_workbench.document().own(), path))
        report(*error);
}

void MainWindow::showAbout()
{
    QMessageBox::about(this, tr("About Cradle"),
                       tr("<h3>Cradle %1</h3><p>Learn how a physics engine works by writing one."
                          "</p><p>Free software under the GNU General Public License, version 3 or "
                          "later. Built with Qt, MathJax and valijson.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

void MainWindow::showShortcuts()
{
    QString rows;
    for (const QAction *menu : menuBar()->actions()) {
        for (const QAction *action : menu->menu()->actions()) {
            if (!action->shortcut().isEmpty())
                rows +=
                    QStringLiteral("<tr><td>%1&nbsp;&nbsp;&nbsp;</td><td><b>%2</b></td></tr>")
                        .arg(action->text().remove(QLatin1Char('&')).toHtmlEscaped(),
                             action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped());
        }
    }
    QMessageBox box(QMessageBox::NoIcon, tr("Keyboard shortcuts"),
                    QStringLiteral("<table>%1</table>").arg(rows), QMessageBox::Close, this);
    box.exec();
}

void MainWindow::retranslate()
{
    const QString scene =
        m_workbench.task() ? m_workbench.lab().title : m_workbench.document().preset().name;
    setWindowTitle(scene);
    const std::pair<const char *, QString> titles[] = {
        {"task", tr("Step")},         {"code", tr("lab.lua")},  {"inspector", tr("Inspector")},
        {"momentum", tr("Momentum")}, {"energy", tr("Energy")}, {"values", tr("Values")}};
    for (const auto &[name, title] : titles)
        findChild<QDockWidget *>(QLatin1String(name))->setWindowTitle(title);
    titleTabs();
    showGhost();
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
    m_settings.setValue(QStringLiteral("geometry"), saveGeometry());
    m_settings.setValue(QStringLiteral("layout"), saveState(layoutVersion));
    m_workbench.save();
    event->accept();
}

} // namespace cradle
