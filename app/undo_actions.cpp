// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/undo_actions.h"

#include "views/code/code_editor.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMetaObject>
#include <QPlainTextEdit>
#include <QTextDocument>
#include <QTextEdit>
#include <QUndoStack>

namespace cradle {

namespace {

const QTextDocument *documentOf(const QWidget &field)
{
    if (const auto *text = qobject_cast<const QPlainTextEdit *>(&field))
        return text->document();
    const auto *text = qobject_cast<const QTextEdit *>(&field);
    return text ? text->document() : nullptr;
}

bool canUndo(const QWidget &field)
{
    if (const auto *line = qobject_cast<const QLineEdit *>(&field))
        return line->isUndoAvailable();
    return documentOf(field)->isUndoAvailable();
}

bool canRedo(const QWidget &field)
{
    if (const auto *line = qobject_cast<const QLineEdit *>(&field))
        return line->isRedoAvailable();
    return documentOf(field)->isRedoAvailable();
}

/// Whether \p field keeps the key of Undo to itself: where nothing was typed, some do not.
bool takesUndo(QWidget &field)
{
    const QKeyCombination key = QKeySequence(QKeySequence::Undo)[0];
    QKeyEvent asked(QEvent::ShortcutOverride, key.key(), key.keyboardModifiers());
    asked.ignore();
    QCoreApplication::sendEvent(&field, &asked);
    return asked.isAccepted();
}

/// \p focused if text is typed into it; null else.
QWidget *typedInto(QWidget *focused)
{
    const bool isText = qobject_cast<QLineEdit *>(focused) || documentOf(*focused);
    return isText && !focused->property("readOnly").toBool() ? focused : nullptr;
}

} // namespace

UndoActions::UndoActions(QUndoStack &scene, CodeEditor &program, QMenu &menu)
    : QObject(&menu)
    , m_scene(scene)
    , m_program(program)
    , m_undo(menu.addAction(QString()))
    , m_redo(menu.addAction(QString()))
{
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcut(QKeySequence::Redo);
    connect(m_undo, &QAction::triggered, this, &UndoActions::undo);
    connect(m_redo, &QAction::triggered, this, &UndoActions::redo);
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
    if (m_field)
        m_field->disconnect(this);
    m_field = typedInto(focused);
    m_ofProgram = !m_field && m_program.isAncestorOf(focused) && !m_program.isReadOnly();
    if (auto *line = qobject_cast<QLineEdit *>(m_field))
        connect(line, &QLineEdit::textChanged, this, &UndoActions::show);
    else if (auto *plain = qobject_cast<QPlainTextEdit *>(m_field))
        connect(plain, &QPlainTextEdit::textChanged, this, &UndoActions::show);
    else if (auto *text = qobject_cast<QTextEdit *>(m_field))
        connect(text, &QTextEdit::textChanged, this, &UndoActions::show);
    show();
}

/// The field whose typing is meant now; null if it is the program or the scene.
QWidget *UndoActions::field() const
{
    return m_field && takesUndo(*m_field) ? m_field.data() : nullptr;
}

void UndoActions::undo()
{
    if (QWidget *typed = field())
        QMetaObject::invokeMethod(typed, "undo");
    else if (m_ofProgram)
        m_program.undo();
    else
        m_scene.undo();
}

void UndoActions::redo()
{
    if (QWidget *typed = field())
        QMetaObject::invokeMethod(typed, "redo");
    else if (m_ofProgram)
        m_program.redo();
    else
        m_scene.redo();
}

void UndoActions::show()
{
    const auto name = [](const QString &what, const QString &of) {
        return of.isEmpty() ? what : what + QLatin1Char(' ') + of;
    };
    const QWidget *typed = field();
    const auto choose = [&](bool ofField, bool ofProgram, bool ofScene) {
        return typed ? ofField : m_ofProgram ? ofProgram : ofScene;
    };
    const bool undoes = choose(typed && canUndo(*typed), m_program.canUndo(), m_scene.canUndo());
    const bool redoes = choose(typed && canRedo(*typed), m_program.canRedo(), m_scene.canRedo());
    m_undo->setEnabled(undoes);
    m_redo->setEnabled(redoes);
    QString undone = m_scene.undoText();
    QString redone = m_scene.redoText();
    if (typed || m_ofProgram) {
        undone = undoes ? tr("typing") : QString();
        redone = redoes ? tr("typing") : QString();
    }
    m_undo->setText(name(tr("&Undo"), undone));
    m_redo->setText(name(tr("&Redo"), redone));
}

} // namespace cradle
