// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// Markdown of a student's note as HTML: paragraphs, headings, lists, emphasis, code, formulas as
/// plain letters. Nothing of it is taken for HTML, and nothing is loaded: links show as text.
[[nodiscard]] QString markdownHtml(const QString &markdown);

} // namespace cradle
