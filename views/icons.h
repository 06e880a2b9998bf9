// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QStringView>

namespace cradle {

/// The colour that an icon's lines take, from the theme in force when it is painted.
enum class IconTint { Text, Muted, Accent, OnAccent, Success, Warning };

/// The line icon :/icons/NAME.svg, sharp at any scale and always in the colours of the theme in
/// force; muted where the widget is disabled. A null icon if there is none of that name.
QIcon icon(QStringView name, IconTint tint = IconTint::Text);

/// The muted arrow of what can be opened: down if it is open, else to where one reads on.
QIcon openingIcon(bool isOpen);

} // namespace cradle
