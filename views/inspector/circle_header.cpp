// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/circle_header.h"

#include "views/inspector/circle_table_model.h"
#include "views/theme.h"

#include <QPainter>

#include <algorithm>

namespace cradle {

namespace {

constexpr int margin = 4;       ///< px, as in the cells
constexpr int symbolTop = 1;    ///< px
constexpr double lowered = 0.2; ///< of the line's height
constexpr double indexSize = 0.8;

} // namespace

CircleHeader::CircleHeader(QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent)
{
    setSectionsClickable(false);
    setHighlightSections(false);
    setMinimumSectionSize(22);
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
    const int symbol = large.horizontalAdvance(parts.symbol) + small.horizontalAdvance(parts.index);
    return std::max(symbol, small.horizontalAdvance(parts.unit)) + 2 * margin;
}

QSize CircleHeader::sectionSizeFromContents(int logicalIndex) const
{
    const int unitHeight = QFontMetrics(smallFont()).height();
    return {widthOf(logicalIndex), symbolTop + fontMetrics().height() + unitHeight + 2};
}

void CircleHeader::paintSection(QPainter *painter, const QRect &rect, int logicalIndex) const
{
    const Parts parts = partsOf(logicalIndex);
    painter->save();
    painter->fillRect(rect, theme().panel);
    painter->setPen(theme().border);
    painter->drawLine(rect.bottomLeft(), rect.bottomRight());
    const auto alignment = model()->headerData(logicalIndex, Qt::Horizontal, Qt::TextAlignmentRole);
    const bool right = (alignment.toInt() & Qt::AlignRight) != 0;
    const QFontMetrics large(font());
    const QFontMetrics small(smallFont());
    const auto leftOf = [&](int width) {
        return right ? rect.right() + 1 - margin - width : rect.left() + margin;
    };
    const int symbol = large.horizontalAdvance(parts.symbol);
    const int x = leftOf(symbol + small.horizontalAdvance(parts.index));
    const int baseline = rect.top() + symbolTop + large.ascent();
    painter->setLayoutDirection(Qt::LeftToRight); // "1000 kg/m³" is no sentence
    painter->setPen(theme().text);
    painter->setFont(font());
    painter->drawText(x, baseline, parts.symbol);
    painter->setFont(smallFont());
    painter->drawText(x + symbol, baseline + static_cast<int>(lowered * large.height()),
                      parts.index);
    painter->setPen(theme().mutedText);
    painter->drawText(leftOf(small.horizontalAdvance(parts.unit)),
                      baseline + large.descent() + small.ascent(), parts.unit);
    painter->restore();
}

} // namespace cradle
