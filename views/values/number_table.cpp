// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/number_table.h"

#include "views/theme.h"
#include "views/values/symbol_header.h"

namespace cradle {

void setNumberRows(QTableView *table)
{
    table->verticalHeader()->setMinimumSectionSize(scaledByText(numberRowHeight));
    table->verticalHeader()->setDefaultSectionSize(scaledByText(numberRowHeight));
}

QTableView *makeNumberTable(QAbstractItemModel *model, int unitRole)
{
    auto *table = new QTableView;
    table->setLayoutDirection(Qt::LeftToRight); // else signs and units change sides
    table->setHorizontalHeader(new SymbolHeader(unitRole, table));
    table->setVerticalHeader(new NumberHeader(table));
    table->setModel(model);
    table->setStyleSheet(
        QStringLiteral("QTableCornerButton::section { background: transparent; border: none; }"));
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setCornerButtonEnabled(false);
    table->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table->setTabKeyNavigation(false);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->horizontalHeader()->setMinimumSectionSize(32);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setNumberRows(table);
    return table;
}

} // namespace cradle
