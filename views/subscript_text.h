// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPainter>

namespace cradle {

/// The width of \p text (px), where a symbol like "p_x" takes its second letter as a subscript.
[[nodiscard]] double subscriptWidth(const QFont &font, const QString &text);

/// Draws \p text in the painter's font and pen from \p baseline on, with such subscripts.
void drawSubscripted(QPainter &painter, QPointF baseline, const QString &text);

} // namespace cradle
