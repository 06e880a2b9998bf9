// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/circle_header.h"

#include "views/inspector/circle_table_model.h"
#include "views/theme.h"

#include <QPainter>

namespace cradle {

namespace {

constexpr int margin = 4;       ///< px, as in the cells
constexpr int unitGap = 4;      ///< px between symbol and unit
constexpr double lowered = 0.2; ///< of the line's height
constexpr double indexSize = 0.8;

} // namespace

CircleHeader::CircleHeader(QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent)
{
    setSectionsClickable(false);
    setHighlightSections(false);
    setMinimumSectionSize(28);
}

CircleHeader::Parts CircleHeader::partsOf(int section) const
{
    const QString text = model()->headerData(section, Qt::Horizontal).toString();
    return {text.section(QLatin1Char('_'), 0, 0), text.section(QLatin1Char('_'), 1),
            model()->headerData(section, Qt::Horizontal, CircleTableModel::unitRole).toString()};
}

QFont CircleHeader::smallFont() const
{
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * indexSize);
    return small;
}

int CircleHeader::widthOf(int section) const
{
    const Parts parts = partsOf(section);
    const QFontMetrics large(font());
    const QFontMetrics small(smallFont());
    const int unit = parts.unit.isEmpty() ? 0 : unitGap + small.horizontalAdvance(parts.unit);
    return large.horizontalAdvance(parts.symbol) + small.horizontalAdvance(parts.index) + unit
           + 2 * margin;
}

QSize CircleHeader::sectionSizeFromContents(int logicalIndex) const
{
    return {widthOf(logicalIndex), fontMetrics().height() + 8};
}

void CircleHeader::paintSection(QPainter *painter, const QRect &rect, int logicalIndex) const
{
    const Parts parts = partsOf(logicalIndex);
    painter->save();
    painter->fillRect(rect, theme().panel);
    painter->setPen(theme().border);
    painter->drawLine(rect.bottomLeft(), rect.bottomRight());
    const auto alignment = model()->headerData(logicalIndex, Qt::Horizontal, Qt::TextAlignmentRole);
    int x = rect.left() + margin;
    if (alignment.toInt() & Qt::AlignRight)
        x = rect.right() + 1 - widthOf(logicalIndex) + margin;
    const auto draw = [&](const QString &text, const QFont &textFont, int drop) {
        painter->setFont(textFont);
        const int width = QFontMetrics(textFont).horizontalAdvance(text);
        painter->drawText(QRect(x, rect.top() + drop, width + 1, rect.height()),
                          Qt::AlignLeft | Qt::AlignVCenter, text);
        x += width;
    };
    painter->setPen(theme().text);
    draw(parts.symbol, font(), 0);
    draw(parts.index, smallFont(), static_cast<int>(lowered * rect.height()));
    x += unitGap;
    painter->setPen(theme().mutedText);
    draw(parts.unit, smallFont(), 1);
    painter->restore();
}

} // namespace cradle
