// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <QPointer>

QT_BEGIN_NAMESPACE
class QMenu;
class QUndoStack;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;

/// Undo and Redo of what the student works on: of the program or a field of text while that has the
/// keyboard, else of the scene. Their texts say which.
class UndoActions final : public QObject
{
    Q_OBJECT
public:
    /// Adds both to \p menu, which owns them. \p scene and \p program are borrowed.
    UndoActions(QUndoStack &scene, CodeEditor &program, QMenu &menu);

private:
    void follow(QWidget *focused);
    void undo();
    void redo();
    void show();
    [[nodiscard]] QWidget *field() const;

    QUndoStack &m_scene;
    CodeEditor &m_program;
    QAction *m_undo;
    QAction *m_redo;
    bool m_ofProgram = false;
    QPointer<QWidget> m_field; ///< of text, which has the keyboard; null if none has
};

} // namespace cradle
