// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QString>

namespace cradle {

/// The hunks of a unified diff ("@@ -4,3 +4,2 @@" and lines with " ", "-" or "+") that make
/// \p after of \p before; empty if both have the same lines. Texts end with a line end, or it is
/// as if they did.
[[nodiscard]] QString unifiedDiff(const QString &before, const QString &after, int context = 3);

/// Applies the hunks of \p diff, in order. One whose lines have moved applies where they are now;
/// one at whose ends up to two of the lines around the change are others applies where the rest
/// stands exactly once. \return the text with a line end at its end; an Error with the line of
/// \p diff, from 1, whose hunk does not apply or is none
[[nodiscard]] Result<QString> withDiff(const QString &before, const QString &diff);

} // namespace cradle
