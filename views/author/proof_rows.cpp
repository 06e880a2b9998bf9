// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/proof_rows.h"

#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/theme.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace cradle {

ProofRows::ProofRows(QWidget *parent)
    : QScrollArea(parent)
{
    setObjectName(QStringLiteral("proofRows"));
    auto *holder = new QWidget(this);
    m_rows = new QVBoxLayout(holder);
    m_rows->setContentsMargins(12, 8, 12, 8);
    m_rows->setSpacing(6);
    m_rows->addStretch(1);
    setWidgetResizable(true);
    setWidget(holder);
}

bool ProofRows::isEmpty() const
{
    return m_rows->count() == 1; // the stretch
}

void ProofRows::clear()
{
    while (!isEmpty()) {
        QLayoutItem *item = m_rows->takeAt(0);
        if (QWidget *row = item->widget()) {
            row->hide();
            row->deleteLater(); // its button may be at work
        }
        delete item;
    }
}

void ProofRows::addHeading(const QString &text)
{
    QLabel *heading = makeHeading(widget());
    heading->setText(text);
    m_rows->insertWidget(m_rows->count() - 1, heading);
}

QPushButton *ProofRows::addRow(const QString &text, bool warning, const QString &action)
{
    auto *row = new QWidget(widget());
    auto *line = layOutRow(row, {}, 8);
    auto *label = new QLabel(text, row);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    if (warning)
        setKind(label, "warning");
    line->addWidget(label, 1);
    QPushButton *button = nullptr;
    if (!action.isEmpty()) {
        button = new QPushButton(action, row);
        setKind(button, "small");
        line->addWidget(button, 0, Qt::AlignTop);
    }
    m_rows->insertWidget(m_rows->count() - 1, row);
    return button;
}

} // namespace cradle
