// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How CodeEditor marks lines, shows the message of an error, and scrolls to them.
#include "views/code/code_colours.h"
#include "views/code/code_editor.h"
#include "views/code/lua_area.h"
#include "views/theme.h"

#include <Qsci/qscistyle.h>

#include <QScrollBar>

#include <algorithm>

namespace cradle {

namespace {

constexpr int messageRoom = 48; ///< px right of a message

/// \p text in lines no wider than \p width px.
QString wrapped(const QString &text, const QFont &font, int width)
{
    const QFontMetrics metrics(font);
    QStringList lines;
    for (const QString &paragraph : text.split(u'\n')) {
        QString line;
        for (const QString &word : paragraph.split(u' ')) {
            const QString longer = line.isEmpty() ? word : line + u' ' + word;
            if (!line.isEmpty() && metrics.horizontalAdvance(longer) > width) {
                lines.append(line);
                line = word;
            } else {
                line = longer;
            }
        }
        lines.append(line);
    }
    return lines.join(u'\n');
}

} // namespace

void CodeEditor::setError(int line, const QString &message)
{
    m_errorLine = std::max(line, 0);
    m_errorMessage = message;
    applyMarks();
}

void CodeEditor::clearError()
{
    setError(0, {});
}

void CodeEditor::setSuspect(int line)
{
    m_suspectLine = std::max(line, 0);
    applyMarks();
}

void CodeEditor::setChanged(const std::vector<int> &lines)
{
    m_changedLines = lines;
    applyMarks();
}

void CodeEditor::setExecuting(int line)
{
    m_executingLine = std::max(line, 0);
    applyMarks();
    if (m_executingLine > 0)
        m_area->send(QsciScintillaBase::SCI_ENSUREVISIBLEENFORCEPOLICY,
                     static_cast<unsigned long>(existing(m_executingLine)));
}

/// From 0; an error at the end of the text may be said to be in a line after the last.
int CodeEditor::existing(int line) const
{
    return std::clamp(line - 1, 0, std::max(0, m_area->lines() - 1));
}

void CodeEditor::applyMarks()
{
    m_area->markerDeleteAll();
    const auto mark = [this](int line, LuaArea::Mark background, LuaArea::Mark sign) {
        if (line < 1)
            return;
        m_area->markerAdd(existing(line), background);
        m_area->markerAdd(existing(line), sign);
    };
    for (const int line : m_changedLines)
        mark(line, LuaArea::ChangedLine, LuaArea::ChangedMark);
    mark(m_suspectLine, LuaArea::SuspectLine, LuaArea::SuspectMark);
    mark(m_executingLine, LuaArea::ExecutingLine, LuaArea::ExecutingMark);
    mark(m_errorLine, LuaArea::ErrorLine, LuaArea::ErrorMark);
    showErrorMessage();
    describe();
}

void CodeEditor::showErrorMessage()
{
    m_area->clearAnnotations();
    m_area->setScrollWidth(1); // it grows again with what is shown
    if (m_errorLine < 1 || m_errorMessage.isEmpty())
        return;
    const CodeColours colours = codeColours();
    QFont zoomed = font();
    zoomed.setPointSizeF(std::max(6.0, zoomed.pointSizeF() + zoom()));
    const int line = existing(m_errorLine);
    const int indent = m_area->indentation(line) * QFontMetrics(numericFont()).averageCharWidth();
    const int room = m_area->viewport()->width() - m_area->textLeft() - indent - messageRoom;
    const QsciStyle style(LuaArea::messageStyle, QStringLiteral("message"), colours.error,
                          colours.errorLine, font());
    m_area->annotate(line, wrapped(m_errorMessage, zoomed, std::max(room, 160)), style);
    revealMessage(m_errorLine);
}

/// What is marked, for those who do not see it.
void CodeEditor::describe()
{
    QStringList said;
    if (m_errorLine > 0)
        said << tr("Error in line %1: %2").arg(m_errorLine).arg(m_errorMessage);
    if (m_suspectLine > 0)
        said << tr("Line %1 made the first failing step").arg(m_suspectLine);
    if (m_executingLine > 0)
        said << tr("Line %1 runs next").arg(m_executingLine);
    if (!isReadOnly())
        said << tr("Tab indents; Ctrl+Tab, or Escape and then Tab, leaves the editor");
    m_area->setAccessibleName(accessibleName().isEmpty() ? tr("Program") : accessibleName());
    m_area->setAccessibleDescription(said.join(QStringLiteral(". ")));
}

void CodeEditor::revealLine(int line)
{
    m_area->ensureLineVisible(existing(line));
    const Rows rows = rowsOf(line);
    if (rows.first < rows.top || rows.first >= rows.top + rows.seen)
        m_area->setFirstVisibleLine(std::max(0, rows.first - rows.seen / 2));
    revealMessage(line);
}

/// Scrolls on as far as a message below \p line reaches, if the line is seen and stays so.
void CodeEditor::revealMessage(int line)
{
    const Rows rows = rowsOf(line);
    const int end = rows.first + rows.count;
    if (rows.first >= rows.top && rows.first < rows.top + rows.seen && end > rows.top + rows.seen)
        m_area->setFirstVisibleLine(std::min(rows.first, end - rows.seen));
}

CodeEditor::Rows CodeEditor::rowsOf(int line) const
{
    const auto ask = [this](unsigned int message, int of = 0) {
        return static_cast<int>(m_area->SendScintilla(message, static_cast<unsigned long>(of)));
    };
    const int at = existing(line);
    // The bar below may come only when all is drawn.
    const int height = m_area->height() - m_area->horizontalScrollBar()->sizeHint().height();
    return {.first = ask(QsciScintillaBase::SCI_VISIBLEFROMDOCLINE, at),
            .count = 1 + ask(QsciScintillaBase::SCI_ANNOTATIONGETLINES, at),
            .top = m_area->firstVisibleLine(),
            .seen = std::max(1, height / ask(QsciScintillaBase::SCI_TEXTHEIGHT, at))};
}

void CodeEditor::goToLine(int line)
{
    m_area->ensureLineVisible(existing(line));
    m_area->setCursorPosition(existing(line), 0);
    m_area->ensureCursorVisible();
}

int CodeEditor::linesInSight() const
{
    return static_cast<int>(m_area->SendScintilla(QsciScintillaBase::SCI_LINESONSCREEN));
}

} // namespace cradle
