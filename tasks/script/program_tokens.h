// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace cradle {

/// A word or sign of a Lua program; comments and white space are none.
struct ProgramToken {
    enum class Kind { Name, Keyword, Number, Text, Sign };

    Kind kind = Kind::Sign;
    QString text;
    qsizetype start = 0; ///< where it begins in the source
    int line = 1;        ///< from 1

    [[nodiscard]] qsizetype end() const { return start + text.size(); }
    [[nodiscard]] bool is(const char *word) const
    {
        return kind != Kind::Text && text == QLatin1String(word);
    }
    /// Whether an operand may end with it, so that a sign behind it has a left side.
    [[nodiscard]] bool endsOperand() const
    {
        return kind == Kind::Name || kind == Kind::Number || kind == Kind::Text || is(")")
               || is("]") || is("}");
    }
};

/// The tokens of \p source, which is a program that can be read.
[[nodiscard]] std::vector<ProgramToken> programTokens(const QString &source);

/// Whether a name of Lua may have it: a letter, a digit or _.
[[nodiscard]] inline bool isOfName(QChar c)
{
    return (c.unicode() < 128 && c.isLetterOrNumber()) || c == u'_';
}

} // namespace cradle
