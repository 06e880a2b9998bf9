// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_menu.h"

#include "app/clipboard_actions.h"
#include "app/code_desk.h"
#include "app/export_menu.h"
#include "app/lab_menu.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/undo_actions.h"
#include "views/announcer.h"
#include "views/charts/chart_pane.h"
#include "views/code/code_pane.h"
#include "views/menu.h"
#include "views/scene/scene_view.h"
#include "views/sound/hit_sounds.h"
#include "views/transport_bar.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>

#include <cmath>

namespace cradle {

namespace {

struct MenuText {
    Q_DECLARE_TR_FUNCTIONS(MainMenu)
};

/// Adds an action that calls a slot of \p target; its shortcut holds in the whole window.
template <typename Target, typename Slot>
QAction *add(Menu *menu, const QString &text, const QKeySequence &shortcut, Target *target,
             Slot slot)
{
    QAction *action = menu->addAction(text);
    action->setShortcut(shortcut);
    QObject::connect(action, &QAction::triggered, target, slot);
    return action;
}

void addExamples(MainWindow &window, Menu *menu)
{
    Menu *scenes = menu->addMenu(MenuText::tr("&Example scenes"));
    for (const Example example : allExamples) {
        QAction *action = scenes->addAction(titleOf(example));
        QObject::connect(action, &QAction::triggered, &window,
                         [w = &window, example] { w->openExample(example); });
    }
}

void addLab(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&Lab"));
    Workbench *bench = &window.workbench();
    menu->addAction(window.transportBar().checkAction());
    menu->addSeparator();
    add(menu, MenuText::tr("&Next step"), QKeySequence(Qt::CTRL | Qt::Key_PageDown), bench,
        &Workbench::openNextTask);
    add(menu, MenuText::tr("&Previous step"), QKeySequence(Qt::CTRL | Qt::Key_PageUp), bench,
        &Workbench::openPreviousTask);
    menu->addSeparator();
    add(menu, MenuText::tr("&Report…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B), &window,
        &MainWindow::openReport);
    add(menu, MenuText::tr("&Hand in…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H), &window,
        &MainWindow::openHandIn);
    add(menu, MenuText::tr("Share with &git…"), {}, &window, &MainWindow::shareWork);
    add(menu, MenuText::tr("Grade a &class…"), {}, &window, &MainWindow::openGrading);
    menu->addSeparator();
    addLabs(window, menu);
    add(menu, MenuText::tr("&Open lab…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), &window,
        &MainWindow::openLabFolder);
    add(menu, MenuText::tr("Open lab in one &file…"), {}, &window, &MainWindow::openLabFile);
    add(menu, MenuText::tr("Open &scene…"), QKeySequence::Open, &window,
        &MainWindow::openPresetFile);
    addExamples(window, menu);
    add(menu, MenuText::tr("&Author a lab…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
        &window, &MainWindow::authorLab);
    add(menu, MenuText::tr("Sa&ve scene as…"), QKeySequence::SaveAs, &window,
        &MainWindow::savePresetAs);
    addExport(window, menu);
    menu->addSeparator();
    add(menu, MenuText::tr("&Quit"), QKeySequence::Quit, &window, &QWidget::close)
        ->setMenuRole(QAction::QuitRole);
}

bool isOfClipboard(const QAction &action)
{
    for (const auto key :
         {QKeySequence::Cut, QKeySequence::Copy, QKeySequence::Paste, QKeySequence::SelectAll}) {
        if (action.shortcut() == QKeySequence(key))
            return true;
    }
    return false;
}

void addEdit(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&Edit"));
    PresetDocument *document = &window.workbench().document();
    SceneView *scene = &window.scene();
    // The menu is filled anew with every language; they belong to it and go with it.
    new UndoActions(document->undoStack(), window.codePane().editor(), *menu);
    menu->addSeparator();
    new ClipboardActions(window, *menu);
    menu->addSeparator();
    add(menu, MenuText::tr("&Add circle"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N), scene,
        [scene] { scene->addCircle(); });
    // The rest of what can be done with circles is above, for whatever has the focus.
    for (QAction *action : scene->circleActions()) {
        if (!isOfClipboard(*action))
            menu->addAction(action);
    }
    menu->addSeparator();
    add(menu, MenuText::tr("Reset to the &step's scene"), {}, document,
        &PresetDocument::resetToOriginal);
}

void addRuns(MainWindow &window, Menu *menu)
{
    MainWindow *w = &window;
    QAction *pin = add(menu, MenuText::tr("&Pin this run"), QKeySequence(Qt::CTRL | Qt::Key_P), w,
                       &MainWindow::pinRun);
    pin->setToolTip(MenuText::tr("Keeps its curves, pale, beneath those of later runs"));
    QAction *unpin =
        add(menu, MenuText::tr("Remo&ve pinned runs"), {}, &window.pins(), &PinnedRuns::clear);
    QAction *here =
        add(menu, MenuText::tr("Start a &new run from here"),
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R), w, &MainWindow::startNewRunHere);
    here->setToolTip(MenuText::tr("The moment shown becomes the start of the scene; the run so far "
                                  "stays in the charts"));
    const auto enable = [w, pin, unpin, here] {
        const Simulation &simulation = w->workbench().simulation();
        pin->setEnabled(!w->pins().isFull() && simulation.recording().last() > 0);
        unpin->setEnabled(!w->pins().runs().empty());
        here->setEnabled(!simulation.atStart());
    };
    QObject::connect(menu, &QMenu::aboutToShow, menu, enable);
    // A shortcut must not find what was disabled when the menu was last seen.
    QObject::connect(menu, &QMenu::aboutToHide, menu, [pin, unpin, here] {
        for (QAction *action : {pin, unpin, here})
            action->setEnabled(true);
    });
}

void addSimulation(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&Simulation"));
    TransportBar &transport = window.transportBar();
    menu->addActions({transport.runAction(), transport.stepAction(), transport.stepBackAction(),
                      transport.nextHitAction(), transport.previousHitAction(),
                      transport.restartAction()});
    menu->addSeparator();
    menu->addActions({transport.slowerAction(), transport.fasterAction()});
    menu->addSeparator();
    addRuns(window, menu);
    menu->addSeparator();
    Simulation *simulation = &window.workbench().simulation();
    QAction *pauses = menu->addAction(MenuText::tr("Pause at &hits"));
    pauses->setCheckable(true);
    pauses->setChecked(simulation->pausesAtHits());
    pauses->setShortcut(Qt::SHIFT | Qt::Key_N);
    pauses->setToolTip(MenuText::tr("A run stops at the step of every collision; Run goes on"));
    QObject::connect(pauses, &QAction::toggled, &window, &MainWindow::pauseAtHits);
    QAction *slows = menu->addAction(MenuText::tr("Slow &motion around hits"));
    slows->setCheckable(true);
    slows->setChecked(simulation->slowsAtHits());
    slows->setShortcut(Qt::SHIFT | Qt::Key_S);
    slows->setToolTip(MenuText::tr("A run goes at 1/8× after every hit, and before those that are "
                                   "recorded already; its steps stay as they are"));
    QObject::connect(slows, &QAction::toggled, &window, &MainWindow::slowAtHits);
    QAction *sounds = menu->addAction(MenuText::tr("S&ounds of hits"));
    sounds->setCheckable(true);
    sounds->setChecked(window.hitSounds().isOn());
    sounds->setShortcut(Qt::SHIFT | Qt::Key_H);
    sounds->setToolTip(MenuText::tr("The heavier a circle, the lower its tone; the greater the "
                                    "impulse, the louder"));
    QObject::connect(sounds, &QAction::toggled, &window, &MainWindow::soundHits);
    QAction *frameTime = menu->addAction(MenuText::tr("Steps as long as the &frames took"));
    frameTime->setCheckable(true);
    frameTime->setChecked(simulation->usesFrameTime());
    frameTime->setToolTip(MenuText::tr("As the original lab did: see why stable timesteps matter"));
    menu->setToolTipsVisible(true);
    QObject::connect(frameTime, &QAction::toggled, simulation, &Simulation::setFrameTime);
}

template <typename Value, typename Choose>
void addChoice(Menu *menu, QActionGroup *group, const QString &text, Value value, Value inForce,
               QObject *context, Choose choose)
{
    QAction *action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(value == inForce);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, context, [choose, value] { choose(value); });
}

void addSceneOptions(MainWindow &window, Menu *menu)
{
    Menu *options = menu->addMenu(MenuText::tr("&Scene shows"));
    SceneView *scene = &window.scene();
    const auto addOption = [&](const QString &text, bool SceneOptions::*member) {
        QAction *action = options->addAction(text);
        action->setCheckable(true);
        action->setChecked(scene->options().*member);
        QObject::connect(action, &QAction::toggled, &window, [w = &window, member](bool on) {
            SceneOptions changed = w->scene().options();
            changed.*member = on;
            w->showInScene(changed);
        });
        return action;
    };
    addOption(MenuText::tr("&Velocities"), &SceneOptions::velocities);
    addOption(MenuText::tr("&Trails"), &SceneOptions::trails);
    addOption(MenuText::tr("&Parts of a hit"), &SceneOptions::hitParts);
    addOption(MenuText::tr("&Loupe at a hit"), &SceneOptions::loupe)
        ->setShortcut(Qt::SHIFT | Qt::Key_Z);
    addOption(MenuText::tr("&Momenta tip to tail"), &SceneOptions::momenta);
    addOption(MenuText::tr("&Centre of mass and its way"), &SceneOptions::centreOfMass);
    addOption(MenuText::tr("&Drawings of the program"), &SceneOptions::programDrawings);
    addOption(MenuText::tr("&Names"), &SceneOptions::names);
    addOption(MenuText::tr("&Grid"), &SceneOptions::grid);
    QAction *exact = add(menu, MenuText::tr("&Exact motion beside the run"),
                         QKeySequence(Qt::CTRL | Qt::Key_E), &window, &MainWindow::showExactMotion);
    exact->setCheckable(true);
    exact->setChecked(window.workbench().simulation().shadow() != nullptr);
    exact->setToolTip(MenuText::tr("Outlines where every circle would be without any error of "
                                   "the integrator, the program or the timestep"));
    QAction *follow = menu->addAction(MenuText::tr("&Follow the centre of mass"));
    follow->setCheckable(true);
    follow->setChecked(scene->followsCentreOfMass());
    follow->setToolTip(MenuText::tr("The view moves along with it: in its frame the momenta of all "
                                    "circles add up to nothing"));
    QObject::connect(follow, &QAction::toggled, &window, &MainWindow::followCentreOfMass);
    add(menu, MenuText::tr("Zoom &in"), QKeySequence::ZoomIn, scene, &SceneView::zoomIn);
    add(menu, MenuText::tr("Zoom &out"), QKeySequence::ZoomOut, scene, &SceneView::zoomOut);
    add(menu, MenuText::tr("Zoom to the hi&t"), QKeySequence(Qt::Key_Z), scene,
        &SceneView::zoomToHit);
    add(menu, MenuText::tr("Show the whole s&quare"), QKeySequence(Qt::CTRL | Qt::Key_0), scene,
        &SceneView::fit);
}

void addCharts(MainWindow &window, Menu *menu)
{
    Menu *charts = menu->addMenu(MenuText::tr("C&harts"));
    const auto all = window.findChildren<ChartPane *>();
    if (all.isEmpty())
        return;
    // They share the time that they show.
    add(charts, MenuText::tr("Zoom &in"), QKeySequence(Qt::ALT | Qt::Key_Plus), all.first(),
        &ChartPane::zoomIn);
    add(charts, MenuText::tr("Zoom &out"), QKeySequence(Qt::ALT | Qt::Key_Minus), all.first(),
        &ChartPane::zoomOut);
    add(charts, MenuText::tr("&Reset zoom"), QKeySequence(Qt::ALT | Qt::Key_0), &window,
        &MainWindow::resetCharts);
}

void addView(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&View"));
    menu->setToolTipsVisible(true);
    addSceneOptions(window, menu);
    menu->addSeparator();
    addCharts(window, menu);

    QAction *full = menu->addAction(MenuText::tr("F&ull screen"));
    full->setCheckable(true);
    full->setChecked(window.isFullScreen());
    full->setShortcut(Qt::Key_F11);
    QObject::connect(full, &QAction::toggled, &window, &MainWindow::showFullScreen);
    const auto addShowing = [&window, menu](const QString &text, const QKeySequence &key,
                                            auto slot) {
        QAction *action = menu->addAction(text);
        action->setCheckable(true);
        action->setShortcut(key);
        QObject::connect(action, &QAction::toggled, &window, slot);
        return action;
    };
    QAction *alone = addShowing(MenuText::tr("Scene &alone"), Qt::CTRL | Qt::Key_F11,
                                &MainWindow::showSceneAlone);
    QAction *presents =
        addShowing(MenuText::tr("P&resentation"), Qt::SHIFT | Qt::Key_F11, &MainWindow::present);
    presents->setToolTip(
        MenuText::tr("Large texts and high contrast; Page Up and Page Down go from "
                     "hit to hit, B makes it black, Esc ends it"));
    const auto showShowing = [w = &window, full, alone, presents] {
        full->setChecked(w->isFullScreen());
        alone->setChecked(w->isSceneAlone());
        presents->setChecked(w->presentation() != nullptr);
    };
    QObject::connect(&window, &MainWindow::showingChanged, menu, showShowing);
    showShowing();
    add(menu, MenuText::tr("Scene in a &window of its own"), {}, &window,
        &MainWindow::openSceneWindow);
    QAction *says = menu->addAction(MenuText::tr("Hits to scree&n readers"));
    says->setCheckable(true);
    says->setChecked(window.announcer().saysHits());
    says->setToolTip(MenuText::tr("They tell every hit that is shown; of a run that goes on, one "
                                  "in a while"));
    QObject::connect(says, &QAction::toggled, &window, &MainWindow::announceHits);
    add(menu, MenuText::tr("Ne&xt pane"), QKeySequence(Qt::Key_F6), &window,
        [w = &window] { w->focusNextPane(1); });
    add(menu, MenuText::tr("Pre&vious pane"), QKeySequence(Qt::SHIFT | Qt::Key_F6), &window,
        [w = &window] { w->focusNextPane(-1); });
    add(menu, MenuText::tr("Into the progra&m"), QKeySequence(Qt::CTRL | Qt::Key_L), &window,
        &MainWindow::focusCode);
    menu->addSeparator();
    Menu *panes = menu->addMenu(MenuText::tr("&Panes"));
    for (QDockWidget *dock : window.panes())
        panes->addAction(dock->toggleViewAction());
    panes->addSeparator();
    QAction *unlock = panes->addAction(MenuText::tr("&Move panes"));
    unlock->setCheckable(true);
    QObject::connect(unlock, &QAction::toggled, &window, &MainWindow::unlockPanes);
    add(panes, MenuText::tr("&Reset layout"), {}, &window, &MainWindow::resetLayout);

    MainWindow *w = &window;
    Menu *themes = menu->addMenu(MenuText::tr("&Colours"));
    auto *themeGroup = new QActionGroup(themes);
    const auto chooseTheme = [w](ThemeChoice choice) { w->chooseTheme(choice); };
    const ThemeChoice theme = window.themeChoice();
    addChoice(themes, themeGroup, MenuText::tr("As the &system"), ThemeChoice::System, theme, w,
              chooseTheme);
    addChoice(themes, themeGroup, MenuText::tr("&Light"), ThemeChoice::Light, theme, w,
              chooseTheme);
    addChoice(themes, themeGroup, MenuText::tr("&Dark"), ThemeChoice::Dark, theme, w, chooseTheme);
    addChoice(themes, themeGroup, MenuText::tr("&High contrast"), ThemeChoice::HighContrast, theme,
              w, chooseTheme);

    Menu *sizes = menu->addMenu(MenuText::tr("Si&ze of texts"));
    auto *sizeGroup = new QActionGroup(sizes);
    const auto inForce = static_cast<int>(std::lround(100.0 * textScale()));
    for (const int percent : {100, 125, 150, 175, 200})
        addChoice(sizes, sizeGroup, MenuText::tr("%1 %").arg(percent), percent, inForce, w,
                  [w](int chosen) { w->chooseTextSize(chosen); });

    Menu *speech = menu->addMenu(MenuText::tr("Lan&guage"));
    auto *speechGroup = new QActionGroup(speech);
    for (const QString &code : languages())
        addChoice(speech, speechGroup, languageName(code), code, currentLanguage(), w,
                  [w](const QString &chosen) { w->chooseLanguage(chosen); });

    Menu *drawing = menu->addMenu(MenuText::tr("Scene drawn &by"));
    auto *drawingGroup = new QActionGroup(drawing);
    const auto chooseRenderer = [w](Renderer renderer) { w->chooseRenderer(renderer); };
    const Renderer renderer = window.scene().renderer();
    addChoice(drawing, drawingGroup, MenuText::tr("&Automatic"), Renderer::Automatic, renderer, w,
              chooseRenderer);
    addChoice(drawing, drawingGroup, MenuText::tr("&OpenGL"), Renderer::OpenGl, renderer, w,
              chooseRenderer);
    addChoice(drawing, drawingGroup, MenuText::tr("&Processor"), Renderer::Raster, renderer, w,
              chooseRenderer);
}

void addHelp(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&Help"));
    add(menu, MenuText::tr("&Reference of the lab's Lua"), QKeySequence(Qt::Key_F1), &window,
        [w = &window] { w->codeDesk().showReference({}); });
    add(menu, MenuText::tr("&Lua for C# people"), {}, &window, &MainWindow::showCSharpSheet);
    add(menu, MenuText::tr("&Tour of the window"), {}, &window, &MainWindow::showTour);
    add(menu, MenuText::tr("&Keyboard shortcuts"), QKeySequence(Qt::CTRL | Qt::Key_Slash), &window,
        &MainWindow::showShortcuts);
    menu->addSeparator();
    add(menu, MenuText::tr("&About Cradle"), {}, &window, &MainWindow::showAbout)
        ->setMenuRole(QAction::AboutRole);
    add(menu, MenuText::tr("About &Qt"), {}, qApp, &QApplication::aboutQt)
        ->setMenuRole(QAction::AboutQtRole);
}

} // namespace

void fillMenuBar(MainWindow &window)
{
    QMenuBar &bar = *window.menuBar();
    // One of them may have asked for this, so they go later.
    for (QMenu *old : bar.findChildren<QMenu *>(QString(), Qt::FindDirectChildrenOnly))
        old->deleteLater();
    bar.clear();
    addLab(window, bar);
    addEdit(window, bar);
    addSimulation(window, bar);
    addView(window, bar);
    addHelp(window, bar);
}

} // namespace cradle
