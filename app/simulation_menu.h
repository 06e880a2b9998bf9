// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenuBar;

namespace cradle {

class MainWindow;

/// Adds the menu Simulation of \p window to \p bar.
void addSimulationMenu(MainWindow &window, QMenuBar &bar);

} // namespace cradle
