// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_editor.h"

#include "views/code/code_assistant.h"
#include "views/code/lua_area.h"
#include "views/code/run_marks.h"
#include "views/menu.h"

#include <QEvent>
#include <QVBoxLayout>

#include <Qsci/qscidocument.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cradle {

/// Those that were open, each with its undo.
struct CodeEditor::Documents {
    std::map<QString, QsciDocument> all{};
};

CodeEditor::CodeEditor(QWidget *parent)
    : QWidget(parent)
    , m_area(new LuaArea(this))
    , m_documents(std::make_unique<Documents>())
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
    return withoutRunMarks(m_area->text());
}

void CodeEditor::setText(const QString &text)
{
    m_loading = true;
    m_assistant->hide();
    QString lines = text;
    lines.replace(QLatin1String("\r\n"), QLatin1String("\n"));
    m_area->setText(withRunMarks(lines));
    m_area->SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    m_area->setCursorPosition(0, 0);
    m_area->setFirstVisibleLine(0);
    m_loading = false;
    m_edited = false;
    forgetMarks();
}

void CodeEditor::forgetMarks()
{
    m_errorLine = m_suspectLine = m_executingLine = 0;
    m_changedLines.clear();
    m_errorMessage.clear();
    applyMarks();
    m_area->fitMargins();
}

void CodeEditor::openDocument(const QString &key, const QString &text)
{
    const auto known = m_documents->all.find(key);
    m_loading = true;
    m_area->setReadOnly(false);
    if (known == m_documents->all.end()) {
        m_area->showDocument(m_documents->all[key]);
        m_loading = false;
        setText(text);
        return;
    }
    m_area->showDocument(known->second);
    m_loading = false;
    m_assistant->hide();
    exchangeText(text);
    m_area->setCursorPosition(0, 0);
    m_area->setFirstVisibleLine(0);
}

void CodeEditor::exchangeText(const QString &text)
{
    QString lines = text;
    lines.replace(QLatin1String("\r\n"), QLatin1String("\n"));
    if (lines != this->text()) {
        m_loading = true;
        m_assistant->hide();
        const bool readOnly = m_area->isReadOnly();
        m_area->setReadOnly(false);
        m_area->replaceBytes(0, m_area->send(QsciScintillaBase::SCI_GETLENGTH),
                             withRunMarks(lines).toUtf8());
        m_area->setReadOnly(readOnly);
        m_loading = false;
    }
    m_edited = false;
    forgetMarks();
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
    Menu menu(this);
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
