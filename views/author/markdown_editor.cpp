// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/markdown_editor.h"

#include "views/author/markdown_highlighter.h"
#include "views/theme.h"

#include <QEvent>
#include <QTextBlock>

#include <algorithm>

namespace cradle {

MarkdownEditor::MarkdownEditor(QWidget *parent)
    : QPlainTextEdit(parent)
    , m_highlighter(new MarkdownHighlighter(document()))
{
    setUndoRedoEnabled(false);
    setTabChangesFocus(true);
    setFrameShape(QFrame::NoFrame);
    document()->setDocumentMargin(12);
    setFont(codeFont());
    connect(this, &QPlainTextEdit::textChanged, this, [this] {
        // New colours are told in the same way.
        const QString text = toPlainText();
        if (m_showing || text == m_text)
            return;
        m_text = text;
        lookForNames();
        emit edited(text);
    });
}

MarkdownEditor::~MarkdownEditor() = default;

QTextCursor MarkdownEditor::selected(qsizetype start, qsizetype length) const
{
    QTextCursor cursor(document());
    cursor.setPosition(static_cast<int>(start));
    cursor.setPosition(static_cast<int>(start + length), QTextCursor::KeepAnchor);
    return cursor;
}

void MarkdownEditor::showText(const QString &text)
{
    const QString before = toPlainText();
    if (text == before)
        return;
    const auto shorter = std::min(before.size(), text.size());
    qsizetype same = 0;
    while (same < shorter && before[same] == text[same])
        ++same;
    qsizetype tail = 0;
    while (tail < shorter - same
           && before[before.size() - 1 - tail] == text[text.size() - 1 - tail])
        ++tail;
    m_showing = true;
    selected(same, before.size() - tail - same)
        .insertText(text.mid(same, text.size() - same - tail));
    m_text = text;
    m_showing = false;
    if (same == 0 && tail == 0)
        moveCursor(QTextCursor::Start); // another text
    lookForNames();
}

void MarkdownEditor::insertParagraph(const QString &text)
{
    QTextCursor cursor = textCursor();
    const QString all = toPlainText();
    if (cursor.position() == 0 && all.startsWith(QLatin1Char('#')))
        cursor.movePosition(QTextCursor::EndOfBlock);
    const QString before = all.left(cursor.selectionStart());
    const QString after = all.mid(cursor.selectionEnd());
    const auto gap = [](bool none, bool half) {
        return none ? QString() : QString(half ? 1 : 2, QLatin1Char('\n'));
    };
    const QString emptyLine = QStringLiteral("\n\n");
    cursor.insertText(
        gap(before.isEmpty() || before.endsWith(emptyLine), before.endsWith(QLatin1Char('\n')))
        + text
        + gap(after.trimmed().isEmpty() || after.startsWith(emptyLine),
              after.startsWith(QLatin1Char('\n'))));
    setTextCursor(cursor);
}

void MarkdownEditor::setKnownNames(const TextNames &known)
{
    m_known = known;
    lookForNames();
}

void MarkdownEditor::goTo(const UnknownName &name)
{
    setTextCursor(selected(name.start, name.length));
    setFocus();
}

void MarkdownEditor::goToLine(int line)
{
    QTextCursor cursor(document()->findBlockByNumber(line - 1));
    cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    setTextCursor(cursor);
    setFocus();
}

void MarkdownEditor::lookForNames()
{
    std::vector<UnknownName> unknown;
    if (!m_known.words.isEmpty()) // else the step is still to be read
        unknown = unknownNames(toPlainText(), m_known);
    QList<QTextEdit::ExtraSelection> marks;
    for (const UnknownName &name : unknown) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = selected(name.start, name.length);
        mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        mark.format.setUnderlineColor(theme().warning);
        marks.append(mark);
    }
    setExtraSelections(marks);
    const bool same = unknown == m_unknown;
    m_unknown = std::move(unknown);
    if (!same)
        emit unknownChanged();
}

void MarkdownEditor::changeEvent(QEvent *event)
{
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_highlighter->rehighlight();
        lookForNames();
    }
}

MarkdownEditor *makeTextField(const QString &name, int height, QWidget *parent)
{
    auto *text = new MarkdownEditor(parent);
    text->setObjectName(name);
    text->document()->setDocumentMargin(6);
    text->setFixedHeight(height);
    setKind(text, "field");
    return text;
}

} // namespace cradle
