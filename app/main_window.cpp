// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "app/author_window.h"
#include "app/code_desk.h"
#include "app/keeping_desk.h"
#include "app/language.h"
#include "app/main_menu.h"
#include "app/notice_bar.h"
#include "views/accessible_roles.h"
#include "views/announcer.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/phase_chart.h"
#include "views/charts/plots_chart.h"
#include "views/charts/speed_histogram.h"
#include "views/code/code_pane.h"
#include "views/code/versions_pane.h"
#include "views/console_view.h"
#include "views/inspector/inspector.h"
#include "views/notes_pane.h"
#include "views/scene/scene_view.h"
#include "views/sound/hit_sounds.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"
#include "views/values_table.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QToolBar>
#include <QVBoxLayout>

namespace cradle {

namespace {

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
    installAccessibleRoles();
    makePanes();
    wireWorkbench();
    wireViews();
    m_scene->setRenderer(
        static_cast<Renderer>(settings.value(QStringLiteral("renderer"), 0).toInt()));
    restoreChoices();
    retranslate();
    // No larger than the screen, with room for its window's frame.
    const QSize room = screen()->availableGeometry().size() - QSize(0, 32);
    resize(firstSize.boundedTo(room));
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    restoreArrangement();
    m_arranging = false;
    m_scene->setFocus();
}

MainWindow::~MainWindow()
{
    for (const QPointer<AuthorWindow> &author : std::as_const(m_authors))
        delete author; // its changes were asked about when this was closed
    delete m_secondScene;
    // Panes go after this has: what they tell then concerns nobody.
    for (QDockWidget *pane : findChildren<QDockWidget *>()) {
        pane->disconnect(this);
        pane->toggleViewAction()->disconnect(this);
    }
}

void MainWindow::makePanes()
{
    Simulation &simulation = m_workbench.simulation();
    PresetDocument &document = m_workbench.document();

    // What is to be said stands across the whole window, where it takes no room from the scene.
    auto *top = new QWidget(this);
    m_transport = new TransportBar(simulation, top);
    m_notice = new NoticeBar(top);
    m_announcer = new Announcer(this);
    m_announcer->follow(simulation);
    m_hitSounds = new HitSounds(simulation, this);
    connect(m_hitSounds, &HitSounds::struck, this,
            [this](const std::vector<Tone> &tones) { play(samplesOf(tones)); });
    auto *rows = new QVBoxLayout(top);
    rows->setContentsMargins({});
    rows->setSpacing(0);
    rows->addWidget(m_transport);
    rows->addWidget(m_notice);
    fixedBar(this, Qt::TopToolBarArea, top, QStringLiteral("transport"));
    m_timeline = new Timeline(simulation, this);
    fixedBar(this, Qt::BottomToolBarArea, m_timeline, QStringLiteral("timeline"));

    m_scene = new SceneView(document, this);
    setCentralWidget(m_scene);

    m_taskPane = new TaskPane(this);
    m_inspector = new Inspector(document, this);
    m_code = new CodePane(this);
    m_code->setTitle({}); // its tab tells it
    m_desk = new CodeDesk(m_workbench, *m_code, m_settings, this);
    m_values = new ValuesPane(simulation, this);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    addPane(m_taskPane, QStringLiteral("task"), Qt::LeftDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setDockNestingEnabled(true);
    addPane(m_code, QStringLiteral("code"), Qt::BottomDockWidgetArea);
    addPane(m_inspector, QStringLiteral("inspector"), Qt::BottomDockWidgetArea);
    m_versions = new VersionsPane(this);
    addPane(m_versions, QStringLiteral("versions"), Qt::BottomDockWidgetArea);
    m_notes = new NotesPane(this);
    addPane(m_notes, QStringLiteral("notes"), Qt::BottomDockWidgetArea);
    m_keeping = new KeepingDesk(m_workbench, *m_versions, *m_notes, this);
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
    m_speeds = new SpeedHistogram(simulation, this);
    m_values->addTab(m_speeds, m_speeds->windowTitle());
    m_phase = new PhaseChart(simulation, this);
    m_values->addTab(m_phase, m_phase->windowTitle());
    unlockPanes(false);
}

QDockWidget *MainWindow::addPane(QWidget *widget, const QString &name, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(this);
    dock->setObjectName(name);
    dock->setWidget(widget);
    addDockWidget(area, dock);
    watchPane(dock);
    m_docks.push_back(dock);
    return dock;
}

void MainWindow::chooseTheme(ThemeChoice choice)
{
    m_theme = choice;
    m_settings.setValue(QStringLiteral("theme"), static_cast<int>(choice));
    applyTheme(choice);
}

void MainWindow::chooseTextSize(int percent)
{
    m_settings.setValue(QStringLiteral("textSize"), percent);
    setTextScale(percent / 100.0);
    if (!m_keepsSizes)
        arrangePanes();
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
    m_keepsSizes = m_keepsSizes || unlocked;
    for (QDockWidget *dock : m_docks) {
        QWidget *old = dock->titleBarWidget();
        // Without a bar of its own a dock shows the style's, with which it is moved and closed.
        dock->setTitleBarWidget(unlocked ? nullptr : new QWidget(dock));
        delete old;
    }
}

void MainWindow::retranslate()
{
    if (m_workbench.task())
        setWindowTitle(m_workbench.lab().title);
    else if (const auto example = m_workbench.example())
        setWindowTitle(titleOf(*example));
    else
        setWindowTitle(m_workbench.document().preset().name);
    const std::pair<const char *, QString> titles[] = {
        {"task", tr("Step")},         {"code", tr("lab.lua")}, {"inspector", tr("Inspector")},
        {"versions", tr("Versions")}, {"notes", tr("Notes")},  {"momentum", tr("Momentum")},
        {"energy", tr("Energy")},     {"values", tr("Values")}};
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
    if (event->type() == QEvent::LayoutDirectionChange && !m_docks.empty())
        restoreArrangement();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    m_keeping->keepNote();
    const bool written = std::all_of(m_authors.cbegin(), m_authors.cend(),
                                     [](const auto &author) { return !author || author->close(); });
    if (!written || !mayClose()) {
        event->ignore();
        return;
    }
    m_settings.setValue(QStringLiteral("geometry"), saveGeometry());
    if (!isSceneAlone())
        keepArrangement();
    m_workbench.save();
    event->accept();
}

} // namespace cradle
