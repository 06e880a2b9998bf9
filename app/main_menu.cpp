// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_menu.h"

#include "app/clipboard_actions.h"
#include "app/export_menu.h"
#include "app/lab_menu.h"
#include "app/main_window.h"
#include "app/menu_entries.h"
#include "app/simulation_menu.h"
#include "app/undo_actions.h"
#include "app/view_menu.h"
#include "app/workbench.h"
#include "views/code/code_pane.h"
#include "views/scene/scene_view.h"
#include "views/transport_bar.h"

#include <QApplication>
#include <QMenuBar>

namespace cradle {

namespace {

void addExamples(MainWindow &window, Menu *menu)
{
    Menu *scenes = menu->addMenu(MenuText::tr("&Example scenes"));
    for (const Example example : allExamples) {
        QAction *action = scenes->addAction(titleOf(example));
        QObject::connect(action, &QAction::triggered, &window,
                         [w = &window.opening(), example] { w->openExample(example); });
    }
}

void addLab(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&Lab"));
    Workbench *bench = &window.workbench();
    menu->addAction(window.transportBar().checkAction());
    menu->addSeparator();
    addEntry(menu, MenuText::tr("&Next step"), QKeySequence(Qt::CTRL | Qt::Key_PageDown), bench,
             &Workbench::openNextTask);
    addEntry(menu, MenuText::tr("&Previous step"), QKeySequence(Qt::CTRL | Qt::Key_PageUp), bench,
             &Workbench::openPreviousTask);
    menu->addSeparator();
    addEntry(menu, MenuText::tr("&Report…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B),
             &window.dialogs(), &WorkDialogs::openReport);
    addEntry(menu, MenuText::tr("&Hand in…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H),
             &window.dialogs(), &WorkDialogs::openHandIn);
    addEntry(menu, MenuText::tr("Share with &git…"), {}, &window.dialogs(),
             &WorkDialogs::shareWork);
    addEntry(menu, MenuText::tr("Grade a &class…"), {}, &window.dialogs(),
             &WorkDialogs::openGrading);
    menu->addSeparator();
    addLabs(window, menu);
    addEntry(menu, MenuText::tr("&Open lab…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
             &window.opening(), &Opening::openLabFolder);
    addEntry(menu, MenuText::tr("Open lab in one &file…"), {}, &window.opening(),
             &Opening::openLabFile);
    addEntry(menu, MenuText::tr("Open &scene…"), QKeySequence::Open, &window.opening(),
             &Opening::openPresetFile);
    addExamples(window, menu);
    addEntry(menu, MenuText::tr("&Author a lab…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
             &window.authors(), &AuthorWindows::authorLab);
    addEntry(menu, MenuText::tr("Sa&ve scene as…"), QKeySequence::SaveAs, &window.opening(),
             &Opening::savePresetAs);
    addExport(window, menu);
    menu->addSeparator();
    addEntry(menu, MenuText::tr("&Quit"), QKeySequence::Quit, &window, &QWidget::close)
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
    addEntry(menu, MenuText::tr("&Add circle"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
             scene, [scene] { scene->addCircle(); });
    // The rest of what can be done with circles is above, for whatever has the focus.
    for (QAction *action : scene->circleActions()) {
        if (!isOfClipboard(*action))
            menu->addAction(action);
    }
    menu->addSeparator();
    addEntry(menu, MenuText::tr("Reset to the &step's scene"), {}, document,
             &PresetDocument::resetToOriginal);
}

void addHelp(MainWindow &window, QMenuBar &bar)
{
    Menu *menu = addMenu(bar, MenuText::tr("&Help"));
    addEntry(menu, MenuText::tr("&Reference of the lab's Lua"), QKeySequence(Qt::Key_F1), &window,
             [w = &window] { w->codeDesk().showReference({}); });
    addEntry(menu, MenuText::tr("&Lua for C# people"), {}, &window.help(),
             &HelpDesk::showCSharpSheet);
    addEntry(menu, MenuText::tr("&Tour of the window"), {}, &window.help(), &HelpDesk::showTour);
    addEntry(menu, MenuText::tr("&Keyboard shortcuts"), QKeySequence(Qt::CTRL | Qt::Key_Slash),
             &window.help(), &HelpDesk::showShortcuts);
    menu->addSeparator();
    addEntry(menu, MenuText::tr("&About Cradle"), {}, &window.help(), &HelpDesk::showAbout)
        ->setMenuRole(QAction::AboutRole);
    addEntry(menu, MenuText::tr("About &Qt"), {}, qApp, &QApplication::aboutQt)
        ->setMenuRole(QAction::AboutQtRole);
}

} // namespace

void fillMenuBar(MainWindow &window)
{
    QMenuBar &bar = *window.menuBar();
    // One of them may have asked for this, so they go later.
    for (Menu *old : bar.findChildren<Menu *>(QString(), Qt::FindDirectChildrenOnly))
        old->deleteLater();
    bar.clear();
    addLab(window, bar);
    addEdit(window, bar);
    addSimulationMenu(window, bar);
    addViewMenu(window, bar);
    addHelp(window, bar);
}

} // namespace cradle
