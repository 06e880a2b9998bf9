// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPainter>

namespace cradle {

/// Draws that the keys act in the plot \p rect, and \p told, what they told last, in a chip with
/// its top left corner at \p corner; nothing if it is empty. The painter's font is that of the
/// chip.
void drawPlotFocus(QPainter &painter, const QRectF &rect, QPointF corner, const QString &told);

/// Of keys without others held: 1 for down, −1 for up, else 0.
[[nodiscard]] inline int wayOf(const QKeyEvent &event)
{
    if ((event.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
        return 0;
    return event.key() == Qt::Key_Down ? 1 : event.key() == Qt::Key_Up ? -1 : 0;
}

/// Whether it asks to hear what is told.
[[nodiscard]] inline bool asksToHear(const QKeyEvent &event)
{
    return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier
           && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter);
}

} // namespace cradle
