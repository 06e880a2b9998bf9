// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/step_delegate.h"

#include "views/icons.h"
#include "views/theme.h"

#include <QPainter>

namespace cradle {

namespace {

constexpr int glyphSize = 18; ///< px
constexpr int left = 12;      ///< px before the glyph
constexpr int barWidth = 3;   ///< px, at the left of the open step

QIcon glyphOf(StepDelegate::State state)
{
    switch (state) {
    case StepDelegate::State::Passed:
        return icon(u"passed", IconTint::Success);
    case StepDelegate::State::Current:
        return icon(u"current", IconTint::Accent);
    case StepDelegate::State::Open:
        break;
    }
    return icon(u"open", IconTint::Muted);
}

} // namespace

void StepDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                         const QModelIndex &index) const
{
    const Theme &colours = theme();
    const bool current = index.data(currentRole).toBool();
    painter->save();
    if (current) {
        painter->fillRect(option.rect, colours.accentSoft);
        painter->fillRect(QRect(option.rect.topLeft(), QSize(barWidth, option.rect.height())),
                          colours.square);
    } else if (option.state & QStyle::State_MouseOver) {
        painter->fillRect(option.rect, colours.hover);
    }
    QRect glyph(0, 0, glyphSize, glyphSize);
    glyph.moveCenter({option.rect.left() + left + glyphSize / 2, option.rect.center().y()});
    glyphOf(static_cast<State>(index.data(stateRole).toInt())).paint(painter, glyph);

    QRect place = option.rect.adjusted(left + glyphSize + 8, 0, -12, 0);
    const QString tag = index.data(tagRole).toString();
    if (!tag.isEmpty()) {
        painter->setPen(colours.mutedText);
        painter->drawText(place, Qt::AlignRight | Qt::AlignVCenter, tag);
        place.setRight(place.right() - option.fontMetrics.horizontalAdvance(tag) - 8);
    }
    QFont font = option.font;
    font.setWeight(current ? QFont::DemiBold : QFont::Normal);
    painter->setFont(font);
    const bool open = index.data(stateRole).toInt() == static_cast<int>(State::Open);
    painter->setPen(open && !current ? colours.mutedText : colours.text);
    const QString title =
        QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, place.width());
    painter->drawText(place, Qt::AlignLeft | Qt::AlignVCenter, title);
    if (option.state & QStyle::State_HasFocus) {
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(colours.accent, 2));
        painter->drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -1), 4, 4);
    }
    painter->restore();
}

QSize StepDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &) const
{
    return {0, std::max(rowHeight, option.fontMetrics.height() + 6)};
}

} // namespace cradle
