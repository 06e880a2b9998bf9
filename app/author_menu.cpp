// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "views/author/proof_tab.h"
#include "views/author/scene_tab.h"
#include "views/author/steps_panel.h"
#include "views/menu.h"

#include <QMenuBar>
#include <QTabWidget>

namespace cradle {

namespace {

template <typename Target, typename Slot>
void add(Menu *menu, const QString &text, const QKeySequence &shortcut, Target *target, Slot slot)
{
    QAction *action = menu->addAction(text);
    action->setShortcut(shortcut);
    QObject::connect(action, &QAction::triggered, target, slot);
}

} // namespace

void AuthorWindow::fillMenus()
{
    // One of them may have asked for this, so they go later.
    for (Menu *old : menuBar()->findChildren<Menu *>(QString(), Qt::FindDirectChildrenOnly))
        old->deleteLater();
    menuBar()->clear();
    Menu *lab = addMenu(*menuBar(), tr("&Lab"));
    add(lab, tr("&New lab…"), QKeySequence::New, this, &AuthorWindow::newLab);
    add(lab, tr("&Open a folder…"), QKeySequence::Open, this, &AuthorWindow::openLab);
    add(lab, tr("Open lab in one &file…"), {}, this, &AuthorWindow::openLabFile);
    lab->addSeparator();
    add(lab, tr("&Save"), QKeySequence::Save, this, &AuthorWindow::save);
    add(lab, tr("Save &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this,
        &AuthorWindow::saveAs);
    add(lab, tr("&Export as one file…"), QKeySequence(Qt::CTRL | Qt::Key_E), this,
        &AuthorWindow::exportLab);
    add(lab, tr("Export for st&udents…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), this,
        &AuthorWindow::exportForStudents);
    add(lab, tr("&Properties…"), QKeySequence(Qt::ALT | Qt::Key_Return), this,
        &AuthorWindow::editProperties);
    lab->addSeparator();
    add(lab, tr("Open as a s&tudent"), QKeySequence(Qt::Key_F5), this,
        &AuthorWindow::openAsStudent);
    lab->addSeparator();
    add(lab, tr("&Close"), QKeySequence::Close, this, &QWidget::close);

    Menu *edit = addMenu(*menuBar(), tr("&Edit"));
    QAction *undo = m_document.undoStack().createUndoAction(edit, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction *redo = m_document.undoStack().createRedoAction(edit, tr("&Redo"));
    QList<QKeySequence> again = QKeySequence::keyBindings(QKeySequence::Redo);
    if (!again.contains(alsoRedo))
        again.append(alsoRedo);
    redo->setShortcuts(again);
    edit->addActions({undo, redo});
    edit->addSeparator();
    add(edit, tr("F&ind and replace in the lab…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H),
        this, &AuthorWindow::openSearch);
    add(edit, tr("Insert the scene as a &figure"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F),
        this, &AuthorWindow::insertFigure);
    add(edit, tr("&Values of lab and step"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V), this,
        &AuthorWindow::openValues);
    add(edit, tr("Start from the moment &shown"), {}, m_sceneTab, &SceneTab::setFromMoment);

    Menu *step = m_stepMenu = addMenu(*menuBar(), tr("&Step"));
    add(step, tr("&Add"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N), m_steps,
        &StepsPanel::addStep);
    add(step, tr("&Duplicate"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D), m_steps,
        &StepsPanel::duplicateStep);
    add(step, tr("&Rename"), {}, m_steps, &StepsPanel::renameStep);
    add(step, tr("Re&move"), {}, m_steps, &StepsPanel::removeStep);
    step->addSeparator();
    add(step, tr("Move &up"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Up), m_steps,
        &StepsPanel::moveUp);
    add(step, tr("Move d&own"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Down), m_steps,
        &StepsPanel::moveDown);

    Menu *proof = addMenu(*menuBar(), tr("&Proof"));
    add(proof, tr("&Verify this step"), QKeySequence(Qt::CTRL | Qt::Key_Return), this, [this] {
        showTab(Proof);
        m_proofTab->verifyStep();
    });
    add(proof, tr("Verify the &lab"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Return), this,
        [this] {
            showTab(Proof);
            m_proofTab->verifyAll();
        });
    add(proof, tr("&Suggest mistakes"), {}, this, [this] {
        showTab(Proof);
        m_proofTab->suggest();
    });

    Menu *view = addMenu(*menuBar(), tr("&View"));
    for (int i = 0; i < m_tabs->count(); ++i)
        add(view, m_tabs->tabText(i), QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i)),
            this, [this, i] { showTab(i); });
}

} // namespace cradle
