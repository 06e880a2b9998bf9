// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace cradle {

class MainWindow;

/// Fills the menu bar of \p window; called again when the language changes.
void fillMenuBar(MainWindow &window);

} // namespace cradle
