// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/console_delegate.h"

#include "views/console_model.h"
#include "views/number_text.h"
#include "views/theme.h"

#include <QPainter>

#include <algorithm>

namespace cradle {

namespace {

constexpr int leastDigits = 4;
constexpr int leftPad = 10;  ///< px left of the steps
constexpr int gap = 12;      ///< px between a step and its line
constexpr int rightPad = 10; ///< px right of a line
constexpr int markWidth = 3; ///< px
constexpr int lineRoom = 4;  ///< px above and below a line together

} // namespace

bool ConsoleDelegate::fit(qint64 lastStep, qsizetype width)
{
    const int digits = std::max(leastDigits, static_cast<int>(QString::number(lastStep).size()));
    if (digits == m_digits && width == m_width)
        return false;
    m_digits = digits;
    m_width = width;
    return true;
}

int ConsoleDelegate::gutter() const
{
    return leftPad + m_digits * QFontMetrics(columnFont()).horizontalAdvance(u'0') + gap;
}

QSize ConsoleDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const
{
    const QFontMetrics metrics(columnFont());
    const int text = static_cast<int>(m_width) * metrics.horizontalAdvance(u'0');
    return {gutter() + text + rightPad, metrics.height() + lineRoom};
}

void ConsoleDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                            const QModelIndex &index) const
{
    const Theme &colours = theme();
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setFont(columnFont());
    if (isSelected)
        painter->fillRect(option.rect, colours.accentSoft);
    painter->setPen(colours.text);
    painter->drawText(option.rect.adjusted(gutter(), 0, 0, 0),
                      Qt::AlignVCenter | Qt::TextSingleLine, index.data().toString());
    // The gutter stays where a long line is scrolled aside.
    const QRect line(0, option.rect.top(), gutter() - gap / 2, option.rect.height());
    painter->fillRect(line, isSelected ? colours.accentSoft : colours.panel);
    paintGutter(*painter, line, index.data(ConsoleModel::stepRole).toLongLong());
    painter->restore();
}

void ConsoleDelegate::paintGutter(QPainter &painter, const QRect &line, qint64 step) const
{
    const Theme &colours = theme();
    const bool isMarked = step == m_marked;
    if (isMarked)
        painter.fillRect(QRect(line.topLeft(), QSize(markWidth, line.height())), colours.accent);
    painter.setPen(isMarked ? colours.accent : colours.mutedText);
    const QString text = step > 0 ? QString::number(step) : tr("load", "printed while loading");
    painter.drawText(line.adjusted(0, 0, gap / 2 - gap, 0), Qt::AlignRight | Qt::AlignVCenter,
                     text);
}

} // namespace cradle
