// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

class AuthorWindow;
class MainWindow;

/// Runs the scene for \p seconds (a number, as text), draws the window in \p size ("1280x800";
/// may be empty) and writes it to \p path. \return the exit status: 0, or 2 with a message on
/// standard error
int takeScreenshot(MainWindow &window, const QString &path, const QString &seconds,
                   const QString &size);

/// Draws the window of an author in that size; its scene stands at \p seconds. \return as above
int takeScreenshot(AuthorWindow &window, const QString &path, const QString &seconds,
                   const QString &size);

} // namespace cradle
