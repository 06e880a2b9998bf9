// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>

#include <vector>

namespace cradle {

/// A word, sign, text, number or comment of a Lua program.
struct LuaToken {
    enum class Kind { Comment, Keyword, Constant, Name, Number, String, Sign };

    Kind kind = Kind::Sign;
    qsizetype start = 0; ///< byte
    qsizetype length = 0;
    bool open = false; ///< a comment or string that the end of the text cuts off

    [[nodiscard]] qsizetype end() const { return start + length; }
    [[nodiscard]] QByteArrayView in(QByteArrayView text) const
    {
        return text.sliced(start, length);
    }
};

/// The tokens of \p text (UTF-8) in order, without the space between them. Any text has tokens:
/// a quoted string that is not closed ends with its line.
[[nodiscard]] std::vector<LuaToken> luaTokens(QByteArrayView text);

/// The words that Lua keeps for itself, but for the constants true, false and nil.
[[nodiscard]] const std::vector<QByteArrayView> &luaKeywords();

} // namespace cradle
