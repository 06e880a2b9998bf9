// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QSize>
#include <QStringView>

namespace cradle {

/// The colour that an icon's lines take, from the theme in force when it is painted.
enum class IconTint { Text, Muted, Accent, OnAccent, Success, Warning };

/// The line icon :/icons/NAME.svg, sharp at any scale and always in the colours of the theme in
/// force; muted where the widget is disabled. A null icon if there is none of that name.
QIcon icon(QStringView name, IconTint tint = IconTint::Text);

/// How many times as large icons are where texts are \p textScale times as large: less, as beside
/// large texts there is no room for icons as large.
double iconScale(double textScale);

/// The size of an icon that is \p pixels wide and high at the usual size of texts.
QSize iconSquare(int pixels);

/// The muted arrow of what can be opened: down if it is open, else to where one reads on.
QIcon openingIcon(bool isOpen);

} // namespace cradle
