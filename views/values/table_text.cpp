// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/table_text.h"

#include <QStringList>

#include <algorithm>
#include <numeric>

namespace cradle {

namespace {

/// The cells of \p rows × \p columns.
QString tabbed(const QAbstractItemModel &model, const QList<int> &rows, const QList<int> &columns)
{
    QStringList lines;
    for (const int row : rows) {
        QStringList cells;
        for (const int column : columns)
            cells.append(model.index(row, column).data().toString().replace(QChar(0x2212), u'-'));
        lines.append(cells.join(u'\t'));
    }
    return lines.join(u'\n') + u'\n';
}

QList<int> upTo(int count)
{
    QList<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

} // namespace

QString textOfCells(const QAbstractItemModel &model, const QModelIndexList &selected)
{
    QList<int> rows;
    QList<int> columns;
    for (const QModelIndex &index : selected) {
        rows.append(index.row());
        columns.append(index.column());
    }
    for (QList<int> *list : {&rows, &columns}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return rows.isEmpty() ? QString() : tabbed(model, rows, columns);
}

QString textOfTable(const QAbstractItemModel &model, int unitRole, const QString &corner)
{
    const auto header = [&model](int i, Qt::Orientation direction, int role = Qt::DisplayRole) {
        return model.headerData(i, direction, role).toString();
    };
    QString text = corner;
    for (int column = 0; column < model.columnCount(); ++column) {
        const QString unit = header(column, Qt::Horizontal, unitRole);
        text += u'\t' + header(column, Qt::Horizontal);
        if (!unit.isEmpty())
            text += QStringLiteral(" (%1)").arg(unit);
    }
    text += u'\n';
    const QList<int> columns = upTo(model.columnCount());
    for (const int row : upTo(model.rowCount()))
        text += header(row, Qt::Vertical) + u'\t' + tabbed(model, {row}, columns);
    return text;
}

} // namespace cradle
