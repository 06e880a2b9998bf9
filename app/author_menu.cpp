// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_menu.h"

#include "app/author_window.h"
#include "app/menu_entries.h"
#include "views/author/find_panel.h"
#include "views/author/proof_tab.h"
#include "views/author/scene_tab.h"
#include "views/author/steps_panel.h"

#include <QMenuBar>
#include <QTabWidget>

namespace cradle {

namespace {

struct AuthorMenuText {
    Q_DECLARE_TR_FUNCTIONS(AuthorMenu)
};

void addLabMenu(AuthorWindow &window, QMenuBar &bar)
{
    AuthorFiles *files = &window.files();
    AuthorExports *exports = &window.exports();
    Menu *lab = addMenu(bar, AuthorMenuText::tr("&Lab"));
    addEntry(lab, AuthorMenuText::tr("&New lab…"), QKeySequence::New, files, &AuthorFiles::newLab);
    addEntry(lab, AuthorMenuText::tr("&Open a folder…"), QKeySequence::Open, files,
             &AuthorFiles::openFolder);
    addEntry(lab, AuthorMenuText::tr("Open lab in one &file…"), {}, files, &AuthorFiles::openFile);
    lab->addSeparator();
    addEntry(lab, AuthorMenuText::tr("&Save"), QKeySequence::Save, files, &AuthorFiles::save);
    addEntry(lab, AuthorMenuText::tr("Save &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
             files, &AuthorFiles::saveAs);
    addEntry(lab, AuthorMenuText::tr("&Export as one file…"), QKeySequence(Qt::CTRL | Qt::Key_E),
             exports, &AuthorExports::exportLab);
    addEntry(lab, AuthorMenuText::tr("Export for st&udents…"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), exports,
             &AuthorExports::exportForStudents);
    addEntry(lab, AuthorMenuText::tr("&Properties…"), QKeySequence(Qt::ALT | Qt::Key_Return),
             &window, &AuthorWindow::editProperties);
    lab->addSeparator();
    addEntry(lab, AuthorMenuText::tr("Open as a s&tudent"), QKeySequence(Qt::Key_F5), &window,
             &AuthorWindow::openAsStudent);
    lab->addSeparator();
    addEntry(lab, AuthorMenuText::tr("&Close"), QKeySequence::Close, &window, &QWidget::close);
}

void addEditMenu(AuthorWindow &window, QMenuBar &bar)
{
    QUndoStack &undoStack = window.document().undoStack();
    Menu *edit = addMenu(bar, AuthorMenuText::tr("&Edit"));
    QAction *undo = undoStack.createUndoAction(edit, AuthorMenuText::tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction *redo = undoStack.createRedoAction(edit, AuthorMenuText::tr("&Redo"));
    QList<QKeySequence> again = QKeySequence::keyBindings(QKeySequence::Redo);
    if (!again.contains(alsoRedo))
        again.append(alsoRedo);
    redo->setShortcuts(again);
    edit->addActions({undo, redo});
    edit->addSeparator();
    addEntry(edit, AuthorMenuText::tr("F&ind and replace in the lab…"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H), window.panes().find,
             [find = window.panes().find] { find->open(); });
    addEntry(edit, AuthorMenuText::tr("Insert the scene as a &figure"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F), &window, &AuthorWindow::insertFigure);
    addEntry(edit, AuthorMenuText::tr("&Values of lab and step"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V), &window.ways(),
             &AuthorWays::openValues);
    addEntry(edit, AuthorMenuText::tr("Start from the moment &shown"), {}, window.panes().scene,
             &SceneTab::setFromMoment);
}

Menu *addStepMenu(StepsPanel *steps, QMenuBar &bar)
{
    Menu *step = addMenu(bar, AuthorMenuText::tr("&Step"));
    addEntry(step, AuthorMenuText::tr("&Add"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
             steps, &StepsPanel::addStep);
    addEntry(step, AuthorMenuText::tr("&Duplicate"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D),
             steps, &StepsPanel::duplicateStep);
    addEntry(step, AuthorMenuText::tr("&Rename"), {}, steps, &StepsPanel::renameStep);
    addEntry(step, AuthorMenuText::tr("Re&move"), {}, steps, &StepsPanel::removeStep);
    step->addSeparator();
    addEntry(step, AuthorMenuText::tr("Move &up"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Up),
             steps, &StepsPanel::moveUp);
    addEntry(step, AuthorMenuText::tr("Move d&own"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Down), steps, &StepsPanel::moveDown);
    return step;
}

void addProofMenu(AuthorWindow &window, QMenuBar &bar)
{
    AuthorPanes *panes = &window.panes();
    Menu *proof = addMenu(bar, AuthorMenuText::tr("&Proof"));
    addEntry(proof, AuthorMenuText::tr("&Verify this step"),
             QKeySequence(Qt::CTRL | Qt::Key_Return), &window, [panes] {
                 panes->showTab(AuthorPanes::Proof);
                 panes->proof->verifyStep();
             });
    addEntry(proof, AuthorMenuText::tr("Verify the &lab"),
             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Return), &window, [panes] {
                 panes->showTab(AuthorPanes::Proof);
                 panes->proof->verifyAll();
             });
    addEntry(proof, AuthorMenuText::tr("&Suggest mistakes"), {}, &window, [panes] {
        panes->showTab(AuthorPanes::Proof);
        panes->proof->suggest();
    });
}

void addTabsMenu(AuthorWindow &window, QMenuBar &bar)
{
    Menu *view = addMenu(bar, AuthorMenuText::tr("&View"));
    const QTabWidget &tabs = *window.panes().tabs;
    for (int i = 0; i < tabs.count(); ++i)
        addEntry(view, tabs.tabText(i),
                 QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i)), &window,
                 [panes = &window.panes(), i] { panes->showTab(i); });
}

} // namespace

Menu *fillMenuBar(AuthorWindow &window)
{
    QMenuBar &bar = *window.menuBar();
    // One of them may have asked for this, so they go later.
    for (Menu *old : bar.findChildren<Menu *>(QString(), Qt::FindDirectChildrenOnly))
        old->deleteLater();
    bar.clear();
    addLabMenu(window, bar);
    addEditMenu(window, bar);
    Menu *steps = addStepMenu(window.panes().steps, bar);
    addProofMenu(window, bar);
    addTabsMenu(window, bar);
    return steps;
}

} // namespace cradle
