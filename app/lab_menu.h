// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle {

class MainWindow;
class Menu;

/// Adds the submenu of the labs that can be opened: those that ship with the program and those in
/// the user's folder of labs, read anew whenever the menu opens. The open one is ticked.
void addLabs(MainWindow &window, Menu *menu);

} // namespace cradle
