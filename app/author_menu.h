// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>

namespace cradle {

class AuthorWindow;
class Menu;

/// For Redo, beside the keys of the platform: what other programs have.
inline const QKeySequence alsoRedo{Qt::CTRL | Qt::Key_Y};

/// Fills the menu bar of \p window; called again when the language changes.
/// \return the menu of steps
Menu *fillMenuBar(AuthorWindow &window);

} // namespace cradle
