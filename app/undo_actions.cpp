// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/undo_actions.h"

#include "views/code/code_editor.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QUndoStack>

namespace cradle {

UndoActions::UndoActions(QUndoStack &scene, CodeEditor &program, QMenu &menu)
    : QObject(&menu)
    , m_scene(scene)
    , m_program(program)
    , m_undo(menu.addAction(QString()))
    , m_redo(menu.addAction(QString()))
{
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcut(QKeySequence::Redo);
    connect(m_undo, &QAction::triggered, this, [this] {
        if (m_ofProgram)
            m_program.undo();
        else
            m_scene.undo();
    });
    connect(m_redo, &QAction::triggered, this, [this] {
        if (m_ofProgram)
            m_program.redo();
        else
            m_scene.redo();
    });
    connect(&menu, &QMenu::aboutToShow, this, &UndoActions::show);
    connect(&scene, &QUndoStack::indexChanged, this, &UndoActions::show);
    connect(&program, &CodeEditor::textEdited, this, &UndoActions::show);
    connect(qApp, &QApplication::focusChanged, this,
            [this](QWidget *, QWidget *now) { follow(now); });
    follow(QApplication::focusWidget());
    show();
}

/// The keyboard goes to the menus, and to other windows, and comes back: neither is work.
void UndoActions::follow(QWidget *focused)
{
    if (!focused || qobject_cast<QMenuBar *>(focused) || qobject_cast<QMenu *>(focused)
        || focused->window() != m_program.window())
        return;
    m_ofProgram = m_program.isAncestorOf(focused) && !m_program.isReadOnly();
    show();
}

void UndoActions::show()
{
    const auto name = [](const QString &what, const QString &of) {
        return of.isEmpty() ? what : what + QLatin1Char(' ') + of;
    };
    const bool undoes = m_ofProgram ? m_program.canUndo() : m_scene.canUndo();
    const bool redoes = m_ofProgram ? m_program.canRedo() : m_scene.canRedo();
    m_undo->setEnabled(undoes);
    m_redo->setEnabled(redoes);
    QString undone = m_scene.undoText();
    QString redone = m_scene.redoText();
    if (m_ofProgram) {
        undone = undoes ? tr("typing") : QString();
        redone = redoes ? tr("typing") : QString();
    }
    m_undo->setText(name(tr("&Undo"), undone));
    m_redo->setText(name(tr("&Redo"), redone));
}

} // namespace cradle
