// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace cradle {

/// Words, numbers and signs; of a text in quotes or brackets only the first sign. They lie in the
/// program's text.
using PlainTokens = std::vector<std::string_view>;

/// Puts the tokens of a program that Lua reads into \p tokens, without comments, as fast as can be.
/// \return false where they are not exact: where texts go on over lines, and with signs that are no
///     Lua
[[nodiscard]] bool readPlainTokens(std::string_view text, PlainTokens &tokens);

/// Whether a token is a word: a name, or one that Lua keeps for itself.
[[nodiscard]] inline bool isName(std::string_view token)
{
    if (token.empty())
        return false;
    const char c = token.front();
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

} // namespace cradle
