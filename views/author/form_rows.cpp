// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/form_rows.h"

#include "views/theme.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

namespace cradle {

QFormLayout *makeFormRows()
{
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    return form;
}

QSplitter *layOutSideBySide(QWidget *whole, const QList<QWidget *> &parts, const QList<int> &widths)
{
    auto *splitter = new QSplitter(Qt::Horizontal, whole);
    for (QWidget *part : parts)
        splitter->addWidget(part);
    splitter->setChildrenCollapsible(false);
    splitter->setSizes(widths);
    auto *column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(splitter);
    return splitter;
}

QScrollArea *scrolled(QWidget *widget)
{
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setWidget(widget);
    scroll->setFocusPolicy(Qt::NoFocus); // what is in it has the keyboard
    return scroll;
}

QLabel *makeMutedText(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    setKind(label, "muted");
    return label;
}

QLabel *makeRefusal(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    setKind(label, "warning");
    label->hide();
    return label;
}

void showRefusal(QLabel *label, const QString &reason)
{
    label->setText(reason);
    label->setVisible(!reason.isEmpty());
}

void markRefused(QWidget *field, bool refused)
{
    field->setProperty("refused", refused);
    field->style()->unpolish(field);
    field->style()->polish(field);
}

void fillKindList(QComboBox *list, const std::vector<KindInfo> &kinds)
{
    list->clear();
    for (const KindInfo &kind : kinds) {
        list->addItem(kind.title, kind.name);
        list->setItemData(list->count() - 1, kind.purpose, Qt::ToolTipRole);
    }
}

} // namespace cradle
