// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// Breaks a text at its spaces into lines of at most \p columns letters, a longer word aside.
/// \param first  what the first line begins with, \p rest what the others do
[[nodiscard]] QString wrapped(const QString &text, int columns, const QString &first,
                              const QString &rest);

/// CommonMark with TeX as plain lines of at most \p columns letters, without a line end at the
/// end: paragraphs and lists are broken anew, fenced code stays, `$\Delta t^2$` becomes Δt².
[[nodiscard]] QString plainText(const QString &markdown, int columns);

/// CommonMark whose formulas have become plain text, for readers that know no TeX.
[[nodiscard]] QString withPlainFormulas(const QString &markdown);

/// Without what no text file may hold: control characters but tab and line end, halves of
/// surrogate pairs, and noncharacters. A program's own words may hold anything.
[[nodiscard]] QString printable(const QString &text);

} // namespace cradle
