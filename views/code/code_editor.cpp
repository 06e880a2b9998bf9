// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_editor.h"

#include "views/code/api_words.h"
#include "views/code/code_assistant.h"
#include "views/code/code_colours.h"
#include "views/code/lua_area.h"
#include "views/theme.h"

#include <Qsci/qscistyle.h>

#include <QEvent>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

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

CodeEditor::CodeEditor(QWidget *parent)
    : QWidget(parent)
    , m_area(new LuaArea(this))
    , m_assistant(new CodeAssistant(m_area))
{
    setFocusProxy(m_area);
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_area);
    // Scintilla is still at work then, and must not be asked or told anything.
    connect(m_area, &QsciScintilla::textChanged, this, [this] {
        if (m_loading || m_edited)
            return;
        m_edited = true;
        QMetaObject::invokeMethod(this, &CodeEditor::tellEdit, Qt::QueuedConnection);
    });
    connect(m_area, &QsciScintilla::cursorPositionChanged, this,
            [this](int line, int column) { emit cursorMoved(line + 1, column + 1); });
    connect(m_area, &LuaArea::helpRequested, this,
            [this] { emit helpRequested(wordUnderCursor()); });
    connect(m_area, &LuaArea::escapePressed, this, &CodeEditor::escapePressed);
    connect(m_area, &LuaArea::contextMenuRequested, this, &CodeEditor::showMenu);
    connect(m_area, &QsciScintillaBase::SCN_ZOOM, this, [this] {
        showErrorMessage();
        emit zoomChanged(zoom());
    });
    describe();
}

CodeEditor::~CodeEditor() = default;

void CodeEditor::tellEdit()
{
    if (std::exchange(m_edited, false))
        emit textEdited();
}

QString CodeEditor::text() const
{
    return m_area->text();
}

void CodeEditor::setText(const QString &text)
{
    m_loading = true;
    m_assistant->hide();
    QString lines = text;
    lines.replace(QLatin1String("\r\n"), QLatin1String("\n"));
    m_area->setText(lines);
    m_area->SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    m_area->setCursorPosition(0, 0);
    m_area->setFirstVisibleLine(0);
    m_loading = false;
    m_edited = false;
    m_errorLine = m_suspectLine = m_executingLine = 0;
    m_errorMessage.clear();
    applyMarks();
    m_area->fitMargins();
}

void CodeEditor::replaceText(const QString &text)
{
    if (text == this->text())
        return;
    int line = 0;
    int column = 0;
    m_area->getCursorPosition(&line, &column);
    const int top = m_area->firstVisibleLine();
    setText(text);
    m_area->setCursorPosition(std::min(line, m_area->lines() - 1), column);
    m_area->setFirstVisibleLine(top);
}

void CodeEditor::setReadOnly(bool readOnly)
{
    m_area->setReadOnly(readOnly);
    m_assistant->hide();
    describe();
}

bool CodeEditor::isReadOnly() const
{
    return m_area->isReadOnly();
}

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

QString CodeEditor::wordUnderCursor() const
{
    static const QStringList owners{QStringLiteral("math"), QStringLiteral("string"),
                                    QStringLiteral("table"), QStringLiteral("draw"),
                                    QStringLiteral("square")};
    int line = 0;
    int column = 0;
    m_area->getCursorPosition(&line, &column);
    const QString text = m_area->text(line);
    const auto isLetter = [&text](qsizetype at) {
        return at >= 0 && at < text.size() && (text[at].isLetterOrNumber() || text[at] == u'_');
    };
    const auto wordAround = [&](qsizetype at) {
        qsizetype start = at;
        while (isLetter(start - 1))
            --start;
        while (isLetter(at))
            ++at;
        return std::pair(start, text.sliced(start, at - start));
    };
    const auto [start, word] = wordAround(column);
    if (start < 2 || text[start - 1] != u'.' || word.isEmpty())
        return word;
    const QString owner = wordAround(start - 1).second;
    return owners.contains(owner) ? owner + u'.' + word : word;
}

int CodeEditor::currentLine() const
{
    int line = 0;
    int column = 0;
    m_area->getCursorPosition(&line, &column);
    return line + 1;
}

void CodeEditor::revealLine(int line)
{
    m_area->ensureLineVisible(existing(line));
    const auto row = static_cast<int>(m_area->SendScintilla(
        QsciScintillaBase::SCI_VISIBLEFROMDOCLINE, static_cast<unsigned long>(existing(line))));
    const auto rows = static_cast<int>(m_area->SendScintilla(QsciScintillaBase::SCI_LINESONSCREEN));
    const int first = m_area->firstVisibleLine();
    if (row < first || row >= first + rows)
        m_area->setFirstVisibleLine(std::max(0, row - rows / 2));
}

void CodeEditor::goToLine(int line)
{
    m_area->ensureLineVisible(existing(line));
    m_area->setCursorPosition(existing(line), 0);
    m_area->ensureCursorVisible();
}

void CodeEditor::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
        m_area->applyLook();
        showErrorMessage();
        break;
    case QEvent::LanguageChange:
        describe();
        break;
    default:
        break;
    }
}

void CodeEditor::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showErrorMessage();
}

void CodeEditor::showMenu(QPoint at)
{
    QMenu menu(this);
    const auto add = [&](const QString &text, const QKeySequence &keys, bool enabled, auto slot) {
        QAction *action = menu.addAction(text, m_area, slot);
        action->setShortcut(keys);
        action->setEnabled(enabled);
    };
    const bool writable = !isReadOnly();
    const bool selected = m_area->hasSelectedText();
    if (writable) {
        add(tr("Undo"), QKeySequence::Undo, canUndo(), [this] { undo(); });
        add(tr("Redo"), QKeySequence::Redo, canRedo(), [this] { redo(); });
        menu.addSeparator();
        add(tr("Cut"), QKeySequence::Cut, selected, [this] { m_area->cut(); });
    }
    add(tr("Copy"), QKeySequence::Copy, selected, [this] { m_area->copy(); });
    if (writable)
        add(tr("Paste"), QKeySequence::Paste, true, [this] { m_area->paste(); });
    add(tr("Select all"), QKeySequence::SelectAll, true, [this] { selectAll(); });
    menu.addSeparator();
    const QString word = wordUnderCursor();
    add(word.isEmpty() ? tr("API reference") : tr("API reference on %1").arg(word),
        QKeySequence(Qt::Key_F1), true, [this, word] { emit helpRequested(word); });
    menu.exec(at);
}

} // namespace cradle
