// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/number_table.h"

#include "views/charts/symbol_header.h"

namespace cradle {

QTableView *makeNumberTable(QAbstractItemModel *model, int unitRole)
{
    auto *table = new QTableView;
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
    table->verticalHeader()->setMinimumSectionSize(numberRowHeight);
    table->verticalHeader()->setDefaultSectionSize(numberRowHeight);
    return table;
}

} // namespace cradle
