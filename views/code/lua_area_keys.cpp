// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/lua_area.h"

#include <QContextMenuEvent>
#include <QKeyEvent>

namespace cradle {

namespace {

Qt::KeyboardModifiers modifiersOf(const QKeyEvent &event)
{
    return event.modifiers() & ~Qt::KeypadModifier;
}

bool isReturn(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

bool isModifier(int key)
{
    return key >= Qt::Key_Shift && key <= Qt::Key_Alt;
}

/// Keys that move in a text, also one that is only read.
bool moves(int key)
{
    return key >= Qt::Key_Home && key <= Qt::Key_PageDown;
}

} // namespace

/// Keys that the window may have given another meaning are the editor's while it has the focus.
bool LuaArea::isOwnKey(const QKeyEvent &event) const
{
    const bool control = modifiersOf(event) == Qt::ControlModifier;
    const bool shifted = modifiersOf(event) == (Qt::ControlModifier | Qt::ShiftModifier);
    switch (event.key()) {
    case Qt::Key_F1:
        return modifiersOf(event) == Qt::NoModifier;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_0:
    case Qt::Key_Slash:
        return control || shifted; // a slash is on 7 in German and Spanish, 0 is shifted in French
    default:
        return false;
    }
}

bool LuaArea::handleOwnKey(const QKeyEvent &event)
{
    if (!isOwnKey(event))
        return false;
    const auto zoom = static_cast<int>(send(SCI_GETZOOM));
    switch (event.key()) {
    case Qt::Key_F1:
        emit helpRequested();
        break;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        QAbstractScrollArea::focusNextPrevChild(event.key() == Qt::Key_Tab
                                                && !(event.modifiers() & Qt::ShiftModifier));
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        setTextSize(zoom + 1);
        break;
    case Qt::Key_Minus:
        setTextSize(zoom - 1);
        break;
    case Qt::Key_0:
        setTextSize(0);
        break;
    case Qt::Key_Slash:
        if (!isReadOnly())
            toggleComment();
        break;
    default:
        return false;
    }
    return true;
}

bool LuaArea::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto &key = *static_cast<QKeyEvent *>(event);
        const bool text = modifiersOf(key) == Qt::NoModifier && !key.text().isEmpty();
        // Keys of a read-only text would else run and step the scene.
        if (isOwnKey(key) || (isReadOnly() && (moves(key.key()) || text))) {
            event->accept();
            return true;
        }
    }
    return QsciScintilla::event(event);
}

void LuaArea::keyPressEvent(QKeyEvent *event)
{
    const bool plain = !(modifiersOf(*event) & ~Qt::ShiftModifier);
    if (event->key() == Qt::Key_Escape && plain) {
        m_leaving = true;
        emit escapePressed();
        return;
    }
    if (!isModifier(event->key()))
        m_leaving = false;
    if (handleOwnKey(*event))
        return;
    if (isReturn(event->key()) && plain && !isReadOnly())
        return breakLine();
    if (event->matches(QKeySequence::Paste))
        return paste();
    // The first of words from the right and the marks round them are one step of Undo.
    const bool isRun = beginsRun(event->text());
    if (isRun)
        SendScintilla(SCI_BEGINUNDOACTION);
    QsciScintilla::keyPressEvent(event);
    if (isRun) {
        markRuns();
        SendScintilla(SCI_ENDUNDOACTION);
    }
}

void LuaArea::inputMethodEvent(QInputMethodEvent *event)
{
    const bool isRun = beginsRun(event->commitString());
    if (isRun)
        SendScintilla(SCI_BEGINUNDOACTION);
    QsciScintilla::inputMethodEvent(event);
    if (isRun) {
        markRuns();
        SendScintilla(SCI_ENDUNDOACTION);
    }
}

void LuaArea::contextMenuEvent(QContextMenuEvent *event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    emit contextMenuRequested(byKey ? viewport()->mapToGlobal(placeOf(cursor()).bottomLeft())
                                    : event->globalPos());
}

void LuaArea::focusOutEvent(QFocusEvent *event)
{
    m_leaving = false;
    QsciScintilla::focusOutEvent(event);
}

/// Tab indents, but after Escape it leaves; where nothing can be typed it leaves at once.
bool LuaArea::focusNextPrevChild(bool next)
{
    if (isReadOnly() || m_leaving)
        return QAbstractScrollArea::focusNextPrevChild(next);
    return false;
}

} // namespace cradle
