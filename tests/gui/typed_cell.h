// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspector/number_field.h"

#include <QTableView>
#include <QTest>

namespace cradle::windows {

/// Types a number into a cell of a table of circles, as people do.
inline void typeIntoCell(QTableView *table, int row, int column, const QString &text)
{
    table->setFocus();
    table->setCurrentIndex(table->model()->index(row, column));
    table->edit(table->currentIndex());
    // The editor of the cell before may still wait for its end.
    NumberField *field = nullptr;
    for (auto *each : table->viewport()->findChildren<NumberField *>()) {
        if (each->isVisible())
            field = each;
    }
    QVERIFY(field);
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

} // namespace cradle::windows
