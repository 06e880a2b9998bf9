// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/solution_view.h"

#include "views/code/code_editor.h"
#include "views/icons.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace cradle {

SolutionView::SolutionView(QWidget *parent)
    : QWidget(parent)
    , m_heading(new QLabel)
    , m_close(new QToolButton)
    , m_editor(new CodeEditor)
{
    m_heading->setFont(headingFont());
    setKind(m_heading, "heading");
    m_close->setIcon(icon(u"close"));
    m_close->setIconSize(iconSquare(14));
    m_close->setAutoRaise(true);
    m_close->setFixedSize(24, 20);
    setKind(m_close, "tiny");
    m_editor->setReadOnly(true);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(12, 3, 6, 1);
    row->addWidget(m_heading, 1);
    row->addWidget(m_close);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_editor, 1);
    setFocusProxy(m_editor);
    connect(m_close, &QToolButton::clicked, this, &SolutionView::closeRequested);
    connect(m_editor, &CodeEditor::escapePressed, this, &SolutionView::closeRequested);
    keepTranslated(this, &SolutionView::retranslate);
}

void SolutionView::setText(const QString &text)
{
    m_editor->setText(text);
}

void SolutionView::retranslate()
{
    m_heading->setText(tr("Reference solution"));
    m_close->setToolTip(tr("Close the reference solution (Esc)"));
    m_close->setAccessibleName(tr("Close the reference solution"));
    m_editor->setAccessibleName(tr("Reference solution"));
}

} // namespace cradle
