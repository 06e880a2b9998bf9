// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/search_term.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace cradle {

class LuaArea;
class CodeAssistant;

/// The editor of a student's program: Lua with line numbers, folding, completion, and marks on
/// lines. Lines count from 1.
///
/// Tab indents. Ctrl+Tab leaves the editor, and so does Tab after Escape.
class CodeEditor final : public QWidget
{
    Q_OBJECT
public:
    explicit CodeEditor(QWidget *parent = nullptr);
    ~CodeEditor() override;

    [[nodiscard]] QString text() const;
    /// Opens another text: nothing of the one before can be had by undo, no mark stays.
    void setText(const QString &text);
    /// The same for a text that is another state of the one shown: the cursor stays.
    void replaceText(const QString &text);
    /// Opens the text of another document; what was undone and done in it before can be again.
    /// \param key  tells the documents apart
    void openDocument(const QString &key, const QString &text);
    /// Puts \p text in the place of the one shown, as one edit that can be undone; it is not told
    /// by textEdited().
    void exchangeText(const QString &text);
    void setReadOnly(bool readOnly);
    [[nodiscard]] bool isReadOnly() const;

    /// Marks the line that is wrong and shows \p message below it; no line below 1 is marked.
    void setError(int line, const QString &message);
    void clearError();
    [[nodiscard]] int errorLine() const { return m_errorLine; }
    /// Marks the line that made the first failing step; 0 for none.
    void setSuspect(int line);
    [[nodiscard]] int suspectLine() const { return m_suspectLine; }
    /// Marks the line that runs next while stepping through, and shows it; 0 for none.
    void setExecuting(int line);
    [[nodiscard]] int executingLine() const { return m_executingLine; }

    /// Marks the lines that differ from another text.
    void setChanged(const std::vector<int> &lines);

    /// The name at the cursor, for the reference: with its library, as "math.sqrt", or alone.
    [[nodiscard]] QString wordUnderCursor() const;
    [[nodiscard]] int currentLine() const;
    [[nodiscard]] int linesInSight() const; ///< that fit wholly
    void goToLine(int line);
    /// Scrolls there if it must, and so that a message below it is seen; the cursor stays.
    void revealLine(int line);
    [[nodiscard]] QString selectedText() const;
    void selectAll();

    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    void undo();
    void redo();

    /// Steps of text size away from the usual one.
    [[nodiscard]] int zoom() const;
    void setZoom(int steps); ///< kept within what can be read
    void zoomIn() { setZoom(zoom() + 1); }
    void zoomOut() { setZoom(zoom() - 1); }
    void resetZoom() { setZoom(0); }

    /// Marks all that \p term matches; an empty one marks nothing.
    SearchPlace highlight(const SearchTerm &term);
    /// Selects the next match, or the one before, around the ends of the text.
    SearchPlace findNext(const SearchTerm &term, bool forward = true);
    /// Selects the first match that begins where the selection begins, or after.
    SearchPlace findHere(const SearchTerm &term);
    /// Replaces the selection if it is a match, then selects the next.
    SearchPlace replaceNext(const SearchTerm &term, const QString &replacement);
    /// \return how many were replaced, in one step of undo
    int replaceAll(const SearchTerm &term, const QString &replacement);

signals:
    /// The user has edited, with undo and redo; once for all that one event does, soon after it.
    void textEdited();
    void helpRequested(const QString &word); ///< F1; \p word may be empty
    void zoomChanged(int steps);
    void escapePressed(); ///< with nothing open over the text

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Where a line is shown, in rows of the text.
    struct Rows {
        int first = 0; ///< of the line
        int count = 0; ///< of the line and the message below it
        int top = 0;   ///< the first that is seen
        int seen = 0;  ///< how many are
    };

    void tellEdit();
    void forgetMarks();
    void revealMessage(int line);
    [[nodiscard]] Rows rowsOf(int line) const;
    void applyMarks();
    void showErrorMessage();
    void describe();
    void showMenu(QPoint at);
    [[nodiscard]] int existing(int line) const;

    struct Documents;

    LuaArea *m_area; ///< child
    std::unique_ptr<Documents> m_documents;
    CodeAssistant *m_assistant; ///< child
    QString m_errorMessage;
    int m_errorLine = 0;
    int m_suspectLine = 0;
    int m_executingLine = 0;
    std::vector<int> m_changedLines;
    bool m_loading = false; ///< setText() is at work
    bool m_edited = false;  ///< textEdited() is still to come
};

} // namespace cradle
