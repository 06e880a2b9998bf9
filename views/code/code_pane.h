// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QSplitter;
QT_END_NAMESPACE

namespace cradle {

class CodeActions;
class CodeEditor;
class CodeHeader;
class FindBar;
class LocalsTable;
class SolutionView;

/// What has become of the text in the editor.
enum class CodeState {
    Saved,
    Unsaved,
    ReadOnly, ///< nothing may be typed
    Broken,   ///< it does not parse: the last good version runs
    NeverRan  ///< it does not parse, and nothing of it has run yet
};

/// The pane with the student's program: editor, buttons, and beside it what belongs to it.
class CodePane final : public QWidget
{
    Q_OBJECT
public:
    explicit CodePane(QWidget *parent = nullptr);

    /// Text, marks, undo, search: see CodeEditor.
    [[nodiscard]] CodeEditor &editor() { return *m_editor; }
    [[nodiscard]] const CodeEditor &editor() const { return *m_editor; }

    void setTitle(const QString &title); ///< "lab.lua" unless set
    void setState(CodeState state);

    /// Whether edits run at once; if not, only after applyRequested().
    void setAppliesAtOnce(bool atOnce);
    [[nodiscard]] bool appliesAtOnce() const;

    /// Enables "Step into line" and "Finish step"; off also takes the executing line and the
    /// locals away.
    void setStepping(bool stepping);
    /// Marks the line that runs next; 0 takes mark and locals away.
    void setExecuting(int line);
    /// Shows the local variables beside the editor.
    void showLocals(const std::vector<ProgramValue> &locals);
    void hideLocals();

    /// Whether the reference solution may be seen: after passing, or after all hints.
    void setSolutionAvailable(bool available);
    void showSolution(const QString &text);
    void hideSolution();
    [[nodiscard]] bool isSolutionShown() const;

    [[nodiscard]] QSize sizeHint() const override { return {700, 264}; }

    void find();
    void replace();

signals:
    void textEdited();
    void applyRequested();                  ///< "Run code", or Ctrl+Shift+Return
    void appliesAtOnceChanged(bool atOnce); ///< by the user
    void lineStepRequested();
    void finishStepRequested();
    void afreshRequested();   ///< start this step afresh; no question was asked yet
    void solutionRequested(); ///< answer with showSolution()
    void helpRequested(const QString &word);

private:
    void wire();
    void retranslate();
    void share();
    [[nodiscard]] static QString textOf(CodeState state);

    CodeActions *m_actions; ///< child
    CodeHeader *m_header;
    QSplitter *m_splitter;
    CodeEditor *m_editor;
    FindBar *m_findBar;
    SolutionView *m_solution;
    LocalsTable *m_locals;
    CodeState m_state = CodeState::Saved;
};

} // namespace cradle
