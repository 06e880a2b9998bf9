// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/symbol_header.h"

#include "views/number_text.h"
#include "views/subscript_text.h"
#include "views/theme.h"

#include <QFontMetricsF>

#include <cmath>

namespace cradle {

namespace {

constexpr int symbolBase = 16;    ///< px from the top to the line of the symbols
constexpr int unitBase = 31;      ///< px to that of the units
constexpr double firstPad = 14.0; ///< px left of the numbers of the rows
constexpr double headerPad = 6.0; ///< px beside a text
constexpr int headerHeight = 38;  ///< px
constexpr int unitPixels = 10;

} // namespace

SymbolHeader::SymbolHeader(int unitRole, QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent)
    , m_unitRole(unitRole)
{
    setSectionsClickable(false);
    setHighlightSections(false);
}

QSize SymbolHeader::sizeHint() const
{
    return {QHeaderView::sizeHint().width(), scaledByText(headerHeight)};
}

QFont SymbolHeader::unitFont() const
{
    QFont small = font();
    small.setPixelSize(scaledByText(unitPixels));
    return small;
}

QString SymbolHeader::symbol(int section) const
{
    return model()->headerData(section, orientation(), Qt::DisplayRole).toString();
}

QString SymbolHeader::unit(int section) const
{
    return model()->headerData(section, orientation(), m_unitRole).toString();
}

QSize SymbolHeader::sectionSizeFromContents(int section) const
{
    const double text = std::max(subscriptWidth(font(), symbol(section)),
                                 QFontMetricsF(unitFont()).horizontalAdvance(unit(section)));
    return {static_cast<int>(std::ceil(text + 2.0 * headerPad)), scaledByText(headerHeight)};
}

void SymbolHeader::paintSection(QPainter *painter, const QRect &rect, int section) const
{
    const Theme &colours = theme();
    painter->save();
    painter->fillRect(rect, colours.panel);
    painter->setPen(colours.border);
    painter->drawLine(rect.bottomLeft(), rect.bottomRight());
    const QVariant alignment = model()->headerData(section, orientation(), Qt::TextAlignmentRole);
    const bool left = alignment.isValid() && (alignment.toInt() & Qt::AlignLeft) != 0;
    const auto draw = [&](const QFont &textFont, const QColor &colour, const QString &text,
                          double baseline) {
        painter->setFont(textFont);
        painter->setPen(colour);
        const double x = left ? rect.left() + headerPad
                              : rect.right() + 1.0 - headerPad - subscriptWidth(textFont, text);
        drawSubscripted(*painter, {x, rect.top() + baseline}, text);
    };
    draw(font(), colours.text, symbol(section), scaledByText(symbolBase));
    draw(unitFont(), colours.mutedText, unit(section), scaledByText(unitBase));
    painter->restore();
}

NumberHeader::NumberHeader(QWidget *parent)
    : QHeaderView(Qt::Vertical, parent)
{
    setSectionsClickable(true);
    setHighlightSections(false);
}

QSize NumberHeader::sectionSizeFromContents(int section) const
{
    const QString text = model()->headerData(section, orientation(), Qt::DisplayRole).toString();
    const double width = QFontMetricsF(columnFont()).horizontalAdvance(text);
    return {static_cast<int>(std::ceil(width + firstPad + headerPad)), defaultSectionSize()};
}

void NumberHeader::paintSection(QPainter *painter, const QRect &rect, int section) const
{
    const QVariant colour = model()->headerData(section, orientation(), Qt::ForegroundRole);
    painter->save();
    painter->fillRect(rect, theme().panel);
    painter->setFont(columnFont());
    painter->setPen(colour.value<QColor>());
    // Beside its row in every language: a table is not mirrored.
    painter->drawText(QRectF(rect).adjusted(0.0, 0.0, -headerPad, 0.0),
                      Qt::AlignRight | Qt::AlignAbsolute | Qt::AlignVCenter,
                      model()->headerData(section, orientation(), Qt::DisplayRole).toString());
    painter->restore();
}

} // namespace cradle
