// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle {

/// From now on the keys that a focused control itself uses stay with it, although they are
/// shortcuts as well: Space presses a focused button, Left and Right move a slider, a tab bar or
/// the cell of a table, and typing begins to edit a cell; Space does not, it is the shortcut's.
/// Calling it again changes nothing.
void guardShortcuts();

} // namespace cradle
