// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace cradle {

/// Where a formula stands in a Markdown text.
struct FormulaSource {
    QString tex;      ///< without the dollars
    QString markdown; ///< as written, with the dollars and the punctuation
    bool display = false;
    QString before;         ///< punctuation that touches it, from which no line break may part it
    QString after;          ///< the same, behind a unit if the formula has one
    bool fromRight = false; ///< it stood isolated in Arabic text, which goes from the right
};

/// A Markdown text whose formulas have given way to marks that Markdown leaves alone.
struct FormulaText {
    QString markdown;
    std::vector<FormulaSource> formulas;

    /// The mark of formula i, which stands for it in `markdown`; captures i.
    static constexpr auto markPattern = u"\uE000([0-9]+)\uE001";
};

/// Finds `$…$` and `$$…$$` much like pandoc: a single `$` opens before a character that is no
/// space, and closes after one and not before a digit, so that "$5 and $6" stays as it is.
/// Code spans, fenced blocks, `\$` and anything across an empty line are no formulas.
/// Formulas in indented code are marked too: the caller must put `FormulaSource::markdown` back.
[[nodiscard]] FormulaText findFormulas(const QString &markdown);

} // namespace cradle
