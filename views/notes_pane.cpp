// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/notes_pane.h"

#include "views/markdown_view.h"
#include "views/on_change.h"

#include <QPlainTextEdit>
#include <QSplitter>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int leastPart = 120; ///< px: a small window has no room for more

} // namespace

NotesPane::NotesPane(QWidget *parent)
    : QWidget(parent)
    , m_editor(new QPlainTextEdit)
    , m_view(new MarkdownView)
{
    m_editor->setFrameShape(QFrame::NoFrame);
    m_editor->setTabChangesFocus(true);
    auto *splitter = new QSplitter(Qt::Horizontal);
    splitter->addWidget(m_editor);
    splitter->addWidget(m_view);
    splitter->setChildrenCollapsible(false);
    splitter->setSizes({400, 400});
    m_editor->setMinimumWidth(leastPart);
    m_view->setMinimumWidth(leastPart);
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(splitter);
    setFocusProxy(m_editor);
    connect(m_editor, &QPlainTextEdit::textChanged, this, [this] {
        m_view->setMarkdown(text(), {});
        if (!m_loading)
            emit edited();
    });
    keepTranslated(this, &NotesPane::retranslate);
}

void NotesPane::setText(const QString &text, bool editable)
{
    m_editor->setReadOnly(!editable);
    if (text == this->text())
        return;
    m_loading = true;
    m_editor->setPlainText(text);
    m_loading = false;
}

QString NotesPane::text() const
{
    return m_editor->toPlainText();
}

void NotesPane::retranslate()
{
    setWindowTitle(tr("Notes"));
    m_editor->setPlaceholderText(tr("What you noted about this step: it becomes part of your "
                                    "report. Markdown, and formulas as $v = a t$."));
    m_editor->setAccessibleName(tr("Notes about this step"));
    m_view->setAccessibleName(tr("The notes, set"));
}

} // namespace cradle
