// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

QT_BEGIN_NAMESPACE
class QMenu;
QT_END_NAMESPACE

namespace cradle {

class MainWindow;

/// Adds the submenu by which charts and the data of the run leave the window.
void addExport(MainWindow &window, QMenu *menu);

} // namespace cradle
