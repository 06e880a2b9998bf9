// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// What is meant where the grammar is broken, and where that stands.
struct GrammarHint {
    QString text{}; ///< empty if we do not know
    int line = 0;   ///< from 1
};

/// What to write in place of what a program has from other languages, such as C#: "+=", braces,
/// types, "else if".
/// \param message  what Lua's parser says, in English
/// \param line     where it says so, from 1; what it could not read may stand in the line before
[[nodiscard]] GrammarHint otherLanguage(const QString &source, int line, const QString &message);

} // namespace cradle
