// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view_menu.h"

#include "app/announcer.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/menu_entries.h"
#include "app/workbench.h"
#include "views/charts/chart_pane.h"
#include "views/scene/scene_view.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenuBar>

#include <cmath>

namespace cradle {

namespace {

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
    Choices *choices = &window.choices();
    const auto addOption = [&](const QString &text, bool SceneOptions::*member) {
        return addToggle(options, text, {}, scene->options().*member, choices,
                         [scene, choices, member](bool on) {
                             SceneOptions changed = scene->options();
                             changed.*member = on;
                             choices->showInScene(changed);
                         });
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
    addToggle(menu, MenuText::tr("&Exact motion beside the run"), Qt::CTRL | Qt::Key_E,
              window.workbench().simulation().shadow() != nullptr, choices,
              &Choices::showExactMotion)
        ->setToolTip(MenuText::tr("Outlines where every circle would be without any error of "
                                  "the integrator, the program or the timestep"));
    addToggle(menu, MenuText::tr("&Follow the centre of mass"), {}, scene->followsCentreOfMass(),
              choices, &Choices::followCentreOfMass)
        ->setToolTip(MenuText::tr("The view moves along with it: in its frame the momenta of all "
                                  "circles add up to nothing"));
}

void addZoom(SceneView *scene, Menu *menu)
{
    addEntry(menu, MenuText::tr("Zoom &in"), QKeySequence::ZoomIn, scene, &SceneView::zoomIn);
    addEntry(menu, MenuText::tr("Zoom &out"), QKeySequence::ZoomOut, scene, &SceneView::zoomOut);
    addEntry(menu, MenuText::tr("Zoom to the hi&t"), QKeySequence(Qt::Key_Z), scene,
             &SceneView::zoomToHit);
    addEntry(menu, MenuText::tr("Show the whole s&quare"), QKeySequence(Qt::CTRL | Qt::Key_0),
             scene, &SceneView::fit);
}

void addCharts(MainWindow &window, Menu *menu)
{
    Menu *charts = menu->addMenu(MenuText::tr("C&harts"));
    ChartPane *first = window.panes().charts().front();
    // They share the time that they show.
    addEntry(charts, MenuText::tr("Zoom &in"), QKeySequence(Qt::ALT | Qt::Key_Plus), first,
             &ChartPane::zoomIn);
    addEntry(charts, MenuText::tr("Zoom &out"), QKeySequence(Qt::ALT | Qt::Key_Minus), first,
             &ChartPane::zoomOut);
    addEntry(charts, MenuText::tr("&Reset zoom"), QKeySequence(Qt::ALT | Qt::Key_0),
             &window.runDesk(), &RunDesk::resetCharts);
}

void addShowing(MainWindow &window, Menu *menu)
{
    Room *room = &window.room();
    Presenter *presenter = &window.presenter();
    QAction *full = addToggle(menu, MenuText::tr("F&ull screen"), Qt::Key_F11,
                              window.isFullScreen(), presenter, &Presenter::showFullScreen);
    QAction *alone = addToggle(menu, MenuText::tr("Scene &alone"), Qt::CTRL | Qt::Key_F11,
                               room->isSceneAlone(), room, &Room::showSceneAlone);
    QAction *presents = addToggle(menu, MenuText::tr("P&resentation"), Qt::SHIFT | Qt::Key_F11,
                                  presenter->layer() != nullptr, presenter, &Presenter::present);
    presents->setToolTip(
        MenuText::tr("Large texts and high contrast; Page Up and Page Down go from "
                     "hit to hit, B makes it black, Esc ends it"));
    QObject::connect(room, &Room::sceneAloneChanged, alone,
                     [room, alone] { alone->setChecked(room->isSceneAlone()); });
    QObject::connect(presenter, &Presenter::presentingChanged, presents,
                     [&window, presenter, full, presents] {
                         full->setChecked(window.isFullScreen());
                         presents->setChecked(presenter->layer() != nullptr);
                     });
    addEntry(menu, MenuText::tr("Scene in a &window of its own"), {}, &window.presenter(),
             &Presenter::openSceneWindow);
    addToggle(menu, MenuText::tr("Hits to scree&n readers"), {}, window.announcer().saysHits(),
              &window.choices(), &Choices::announceHits)
        ->setToolTip(MenuText::tr("They tell every hit that is shown; of a run that goes on, one "
                                  "in a while"));
}

void addKeys(MainWindow &window, Menu *menu)
{
    addEntry(menu, MenuText::tr("Ne&xt pane"), QKeySequence(Qt::Key_F6), &window,
             [w = &window.focusRounds()] { w->focusNextPane(1); });
    addEntry(menu, MenuText::tr("Pre&vious pane"), QKeySequence(Qt::SHIFT | Qt::Key_F6), &window,
             [w = &window.focusRounds()] { w->focusNextPane(-1); });
    addEntry(menu, MenuText::tr("Into the progra&m"), QKeySequence(Qt::CTRL | Qt::Key_L),
             &window.stepDesk(), &StepDesk::focusCode);
}

void addPanes(MainWindow &window, Menu *menu)
{
    Menu *panes = menu->addMenu(MenuText::tr("&Panes"));
    for (QDockWidget *dock : window.panes().docks)
        panes->addAction(dock->toggleViewAction());
    panes->addSeparator();
    addToggle(panes, MenuText::tr("&Move panes"), {}, window.room().isUnlocked(), &window.room(),
              &Room::unlockPanes);
    addEntry(panes, MenuText::tr("&Reset layout"), {}, &window.room(), &Room::resetLayout);
}

void addThemes(MainWindow &window, Menu *menu)
{
    Choices *choices = &window.choices();
    Menu *themes = menu->addMenu(MenuText::tr("&Colours"));
    auto *themeGroup = new QActionGroup(themes);
    const auto chooseTheme = [choices](ThemeChoice choice) { choices->chooseTheme(choice); };
    const ThemeChoice theme = choices->theme();
    addChoice(themes, themeGroup, MenuText::tr("As the &system"), ThemeChoice::System, theme,
              choices, chooseTheme);
    addChoice(themes, themeGroup, MenuText::tr("&Light"), ThemeChoice::Light, theme, choices,
              chooseTheme);
    addChoice(themes, themeGroup, MenuText::tr("&Dark"), ThemeChoice::Dark, theme, choices,
              chooseTheme);
    addChoice(themes, themeGroup, MenuText::tr("&High contrast"), ThemeChoice::HighContrast, theme,
              choices, chooseTheme);
}

void addTextSizes(Choices *choices, Menu *menu)
{
    Menu *sizes = menu->addMenu(MenuText::tr("Si&ze of texts"));
    auto *sizeGroup = new QActionGroup(sizes);
    const auto inForce = static_cast<int>(std::lround(100.0 * textScale()));
    for (const int percent : {100, 125, 150, 175, 200})
        addChoice(sizes, sizeGroup, MenuText::tr("%1 %").arg(percent), percent, inForce, choices,
                  [choices](int chosen) { choices->chooseTextSize(chosen); });
}

void addLanguages(Choices *choices, Menu *menu)
{
    Menu *speech = menu->addMenu(MenuText::tr("Lan&guage"));
    auto *speechGroup = new QActionGroup(speech);
    for (const QString &code : languages())
        addChoice(speech, speechGroup, languageName(code), code, currentLanguage(), choices,
                  [choices](const QString &chosen) { choices->chooseLanguage(chosen); });
}

void addRenderers(MainWindow &window, Menu *menu)
{
    Choices *choices = &window.choices();
    Menu *drawing = menu->addMenu(MenuText::tr("Scene drawn &by"));
    auto *drawingGroup = new QActionGroup(drawing);
    const auto chooseRenderer = [choices](Renderer renderer) { choices->chooseRenderer(renderer); };
    const Renderer renderer = window.scene().renderer();
    addChoice(drawing, drawingGroup, MenuText::tr("&Automatic"), Renderer::Automatic, renderer,
              choices, chooseRenderer);
    addChoice(drawing, drawingGroup, MenuText::tr("&OpenGL"), Renderer::OpenGl, renderer, choices,
              chooseRenderer);
    addChoice(drawing, drawingGroup, MenuText::tr("&Processor"), Renderer::Raster, renderer,
              choices, chooseRenderer);
}

} // namespace

void addViewMenu(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&View"));
    menu->setToolTipsVisible(true);
    addSceneOptions(window, menu);
    addZoom(&window.scene(), menu);
    menu->addSeparator();
    addCharts(window, menu);
    addShowing(window, menu);
    addKeys(window, menu);
    menu->addSeparator();
    addPanes(window, menu);
    addThemes(window, menu);
    addTextSizes(&window.choices(), menu);
    addLanguages(&window.choices(), menu);
    addRenderers(window, menu);
}

} // namespace cradle
