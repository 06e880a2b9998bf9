// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QTextDocument;

namespace cradle {

// Qt 6.4 begins every ordered list of Markdown at 1. Marks carry the numbers through its reader.

/// \p markdown with a mark at every item that begins with a number.
[[nodiscard]] QString markListNumbers(const QString &markdown);

/// Takes the marks out of what was read from markListNumbers(), and lets each list begin with the
/// number of its first item, up to 1000: behind items that are not seen.
void applyListNumbers(QTextDocument *document);

} // namespace cradle
