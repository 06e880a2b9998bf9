// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class QWidget;

namespace cradle {

/// Whether some of it is within all that it lies in. (What its own children cover counts.)
[[nodiscard]] bool isInSight(const QWidget &widget);

/// What Tab stops at in \p part, itself included, as the eye goes: from the top and from where one
/// begins to read. Also what is scrolled out of sight.
[[nodiscard]] std::vector<QWidget *> controlsIn(QWidget &part);

/// Sorts \p parts, all in sight in \p window, by columns from where one begins to read, and each
/// from the top.
void sortByEye(std::vector<QWidget *> &parts, const QWidget &window);

/// Gives \p widget the focus of the keyboard, and scrolls to it where it is out of sight.
/// \param forwards  as by Tab, else as by Shift+Tab
void focusByTab(QWidget &widget, bool forwards);

} // namespace cradle
