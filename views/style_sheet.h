// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/theme.h"

#include <QString>

namespace cradle {

/// Beside the title of a tab, on either side, px.
inline constexpr int tabPadding = 14;
inline constexpr int narrowTabPadding = 5; ///< where tabs are many, or have little room

/// The application's style sheet in the colours of \p theme: hairlines, corners of 6 px,
/// buttons 32 px high, a ring around what has the keyboard focus.
QString styleSheetOf(const Theme &theme);

} // namespace cradle
