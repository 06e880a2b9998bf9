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
#include <cmath>

namespace cradle {

namespace {

constexpr int slack = 4;         ///< px left free, so that no scroll bar comes and goes
constexpr int cellPad = 8;       ///< px left and right of a text together
constexpr int tightPad = 6;      ///< the same where room is scarce: what Qt itself keeps free
constexpr int measuredRows = 50; ///< whose texts make their columns wider

/// In whole pixels: Qt abbreviates what lacks a part of one.
int textWidth(const QString &text, const QFont &font)
{
    return static_cast<int>(std::ceil(QFontMetricsF(font).horizontalAdvance(text)));
}

} // namespace

/// Numbers as wide as they need to be; what is left goes to the names.
void CirclesGroup::layOutColumns()
{
    const int room = m_table->viewport()->width() - slack;
    m_model->setBrief(false);
    m_model->setBrief(nameWidth() + othersWidth() > room);
    for (int column = 0; column < CircleTableModel::ColumnCount; ++column) {
        if (column != CircleTableModel::Name)
            m_table->setColumnWidth(column, columnWidth(column));
    }
    m_table->setColumnWidth(CircleTableModel::Name,
                            std::clamp(room - othersWidth(), nameWidth(), 2 * nameWidth()));
    m_table->viewport()->update();
    m_header->viewport()->update();
}

/// Of the names that circles have at first; where room is scarce, of those that are there.
int CirclesGroup::nameWidth() const
{
    const int usual = textWidth(shownCircleName(plainCircleName(10)), font());
    if (!m_model->isBrief())
        return usual + cellPad;
    int widest = m_header->widthOf(CircleTableModel::Name) - tightPad;
    for (int row = 0; row < std::min(m_model->rowCount(), measuredRows); ++row) {
        const QString name = m_model->index(row, CircleTableModel::Name).data().toString();
        widest = std::max(widest, textWidth(name, font()));
    }
    return std::min(usual, widest) + tightPad;
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
    const bool isBrief = m_model->isBrief();
    if (column == CircleTableModel::Colour)
        return isBrief ? m_header->minimumSectionSize() : rowHeight;
    const bool isText = column == CircleTableModel::IntegratorColumn;
    const QFont shown = isText ? font() : numericFont();
    int widest = 0;
    if (isText) {
        widest = textWidth(m_model->integratorCell(Integrator::SymplecticEuler), shown);
    } else if (column <= CircleTableModel::VelocityY) {
        widest = textWidth(isBrief ? QStringLiteral("-0.0") : QStringLiteral("-0.00"), shown);
    }
    for (int row = 0; row < std::min(m_model->rowCount(), measuredRows); ++row)
        widest = std::max(widest, textWidth(m_model->index(row, column).data().toString(), shown));
    // Without a little more the radius would read as a digit of the velocity.
    const int pad = !isBrief                             ? cellPad
                    : column == CircleTableModel::Radius ? 2 * tightPad
                                                         : tightPad;
    return std::max(m_header->widthOf(column), widest + pad);
}

} // namespace cradle
