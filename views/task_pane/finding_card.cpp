// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/finding_card.h"

#include "views/icons.h"
#include "views/task_pane/message_text.h"
#include "views/task_pane/result_cards.h"
#include "views/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace cradle {

FindingCard::FindingCard(const Finding &finding, bool open, FormulaRenderer *renderer,
                         QWidget *parent)
    : QFrame(parent)
{
    setKind(this, "warningCard");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(4);
    const HeadedText text = splitHeadline(finding.message);

    auto *top = new QHBoxLayout;
    auto *title = new QLabel(withUnits(text.headline), this);
    title->setWordWrap(true);
    title->setTextFormat(Qt::PlainText);
    setKind(title, "warningTitle");
    top->addWidget(title, 1);
    m_expand = new QToolButton(this);
    m_expand->setAutoRaise(true);
    m_expand->setCheckable(true);
    m_expand->setChecked(open);
    m_expand->setToolTip(tr("Show what was measured"));
    m_expand->setAccessibleName(tr("Show what was measured: %1").arg(text.headline));
    setKind(m_expand, "tiny");
    top->addWidget(m_expand, 0, Qt::AlignTop);
    column->addLayout(top);

    auto *rest = new QWidget(this);
    m_body = new QVBoxLayout(rest);
    m_body->setContentsMargins(0, 0, 0, 0);
    m_body->setSpacing(4);
    addMarkdown(m_body, {text.headline, withUnits(text.body)}, renderer);
    column->addWidget(rest);

    const auto show = [this, rest](bool shown) {
        rest->setVisible(shown);
        m_expand->setIcon(openingIcon(shown));
    };
    connect(m_expand, &QToolButton::toggled, rest, show);
    show(open);
}

} // namespace cradle
