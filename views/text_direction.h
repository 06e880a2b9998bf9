// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGuiApplication>
#include <QString>

namespace cradle {

/// For painters of what goes from left to right in every language, such as a chart: the direction
/// of one text in it, without which an Arabic sentence would have its parts in the other order.
[[nodiscard]] inline Qt::LayoutDirection directionOf(const QString &text)
{
    return text.isRightToLeft() ? Qt::RightToLeft : Qt::LeftToRight;
}

/// What goes from left to right in every language, such as "Ctrl++" or a unit, within a text that
/// may go the other way.
[[nodiscard]] inline QString isolated(const QString &text)
{
    return QGuiApplication::isRightToLeft() ? QChar(0x2066) + text + QChar(0x2069) : text;
}

} // namespace cradle
