// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation_menu.h"

#include "app/main_window.h"
#include "app/menu_entries.h"
#include "app/workbench.h"
#include "views/transport_bar.h"

#include <QMenuBar>

namespace cradle {

namespace {

void addRuns(MainWindow &window, Menu *menu)
{
    RunDesk *desk = &window.runDesk();
    const Simulation *simulation = &window.workbench().simulation();
    QAction *pin = addEntry(menu, MenuText::tr("&Pin this run"), QKeySequence(Qt::CTRL | Qt::Key_P),
                            desk, &RunDesk::pinRun);
    pin->setToolTip(MenuText::tr("Keeps its curves, pale, beneath those of later runs"));
    QAction *unpin =
        addEntry(menu, MenuText::tr("Remo&ve pinned runs"), {}, &desk->pins(), &PinnedRuns::clear);
    QAction *here =
        addEntry(menu, MenuText::tr("Start a &new run from here"),
                 QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R), desk, &RunDesk::startNewRunHere);
    here->setToolTip(MenuText::tr("The moment shown becomes the start of the scene; the run so far "
                                  "stays in the charts"));
    const auto enable = [desk, simulation, pin, unpin, here] {
        pin->setEnabled(!desk->pins().isFull() && simulation->recording().last() > 0);
        unpin->setEnabled(!desk->pins().runs().empty());
        here->setEnabled(!simulation->atStart());
    };
    QObject::connect(menu, &QMenu::aboutToShow, menu, enable);
    // A shortcut must not find what was disabled when the menu was last seen.
    QObject::connect(menu, &QMenu::aboutToHide, menu, [pin, unpin, here] {
        for (QAction *action : {pin, unpin, here})
            action->setEnabled(true);
    });
}

} // namespace

void addSimulationMenu(MainWindow &window, QMenuBar &bar)
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
    Choices *choices = &window.choices();
    addToggle(menu, MenuText::tr("Pause at &hits"), Qt::SHIFT | Qt::Key_N,
              simulation->pausesAtHits(), choices, &Choices::pauseAtHits)
        ->setToolTip(MenuText::tr("A run stops at the step of every collision; Run goes on"));
    addToggle(menu, MenuText::tr("Slow &motion around hits"), Qt::SHIFT | Qt::Key_S,
              simulation->slowsAtHits(), choices, &Choices::slowAtHits)
        ->setToolTip(MenuText::tr("A run goes at 1/8× after every hit, and before those that are "
                                  "recorded already; its steps stay as they are"));
    addToggle(menu, MenuText::tr("S&ounds of hits"), Qt::SHIFT | Qt::Key_H,
              window.sounds().hits().isOn(), choices, &Choices::soundHits)
        ->setToolTip(MenuText::tr("The heavier a circle, the lower its tone; the greater the "
                                  "impulse, the louder"));
    addToggle(menu, MenuText::tr("Steps as long as the &frames took"), {},
              simulation->usesFrameTime(), simulation, &Simulation::setFrameTime)
        ->setToolTip(MenuText::tr("As the original lab did: see why stable timesteps matter"));
    menu->setToolTipsVisible(true);
}

} // namespace cradle
