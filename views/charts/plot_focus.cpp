// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/plot_focus.h"

#include "views/text_direction.h"
#include "views/theme.h"

namespace cradle {

namespace {

constexpr double chipRoom = 4.0; ///< px around the text

} // namespace

void drawPlotFocus(QPainter &painter, const QRectF &rect, QPointF corner, const QString &told)
{
    painter.setPen(QPen(theme().accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect.adjusted(1.0, 1.0, -1.0, -1.0));
    if (told.isEmpty())
        return;
    const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, told);
    const QRectF chip(corner + QPointF(chipRoom, chipRoom),
                      size + QSizeF(2.0 * chipRoom, chipRoom));
    painter.fillRect(chip, theme().panel);
    painter.setPen(theme().text);
    painter.setLayoutDirection(directionOf(told));
    painter.drawText(chip, Qt::AlignCenter, told);
    painter.setPen(QPen(theme().accent, 1.0));
    painter.drawRect(chip);
}

} // namespace cradle
