// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How wide the columns of the table of circles are.
#include "views/circle_name.h"
#include "views/inspector/circle_header.h"
#include "views/inspector/circle_table_model.h"
#include "views/inspector/circles_group.h"
#include "views/theme.h"

#include <QTableView>

#include <algorithm>

namespace cradle {

namespace {

constexpr int slack = 4;         ///< px left free, so that no scroll bar comes and goes
constexpr int cellPad = 8;       ///< px left and right of a text together
constexpr int measuredRows = 50; ///< whose texts make their columns wider

} // namespace

/// Numbers as wide as they need to be; what is left goes to the names.
void CirclesGroup::layOutColumns()
{
    const int room = m_table->viewport()->width() - slack;
    const int name =
        fontMetrics().horizontalAdvance(shownCircleName(plainCircleName(10))) + cellPad;
    m_model->setBrief(false);
    m_model->setBrief(name + othersWidth() > room);
    for (int column = 0; column < CircleTableModel::ColumnCount; ++column) {
        if (column != CircleTableModel::Name)
            m_table->setColumnWidth(column, columnWidth(column));
    }
    m_table->setColumnWidth(CircleTableModel::Name,
                            std::clamp(room - othersWidth(), name, 2 * name));
    m_table->viewport()->update();
}

/// Of all columns but the names.
int CirclesGroup::othersWidth() const
{
    int sum = 0;
    for (int column = 0; column < CircleTableModel::ColumnCount; ++column)
        sum += column == CircleTableModel::Name ? 0 : columnWidth(column);
    return sum;
}

/// Room for the header of a column, for its usual texts, and for those that are in it.
int CirclesGroup::columnWidth(int column) const
{
    if (column == CircleTableModel::Colour)
        return rowHeight;
    const bool isText = column == CircleTableModel::IntegratorColumn;
    const QFontMetrics metrics(isText ? fontMetrics() : QFontMetrics(numericFont()));
    int widest = 0;
    if (isText) {
        widest = metrics.horizontalAdvance(m_model->integratorCell(Integrator::SymplecticEuler));
    } else if (column <= CircleTableModel::VelocityY) {
        widest = metrics.horizontalAdvance(QStringLiteral("-0.00"));
    }
    for (int row = 0; row < std::min(m_model->rowCount(), measuredRows); ++row) {
        const QString text = m_model->index(row, column).data().toString();
        widest = std::max(widest, metrics.horizontalAdvance(text));
    }
    return std::max(m_header->widthOf(column), widest + cellPad);
}

} // namespace cradle
