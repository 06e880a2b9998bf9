// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle {

class MainWindow;
class Menu;

/// Adds the submenu by which charts and the data of the run leave the window.
void addExport(MainWindow &window, Menu *menu);

} // namespace cradle
