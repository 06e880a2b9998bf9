// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenuBar;

namespace cradle {

class MainWindow;

/// Adds the menu View of \p window to \p bar.
void addViewMenu(MainWindow &window, QMenuBar &bar);

} // namespace cradle
