// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/plain_tokens.h"

namespace cradle {

namespace {

bool isPlainDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isPlainLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Reads one token after another.
class PlainReader
{
public:
    explicit PlainReader(std::string_view text)
        : m_text(text)
    {
    }

    bool read(PlainTokens &tokens)
    {
        tokens.clear();
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (c == ' ' || c == '\n' || c == '\t') {
                ++m_at;
            } else if (c == '-' && at(1) == '-') {
                if (!skipComment())
                    return false;
            } else {
                const std::size_t start = m_at;
                const std::size_t length = skipToken(c);
                if (length == 0)
                    return false;
                tokens.push_back(m_text.substr(start, length));
            }
        }
        return true;
    }

private:
    [[nodiscard]] char at(std::size_t ahead) const
    {
        return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
    }

    /// Of the token that begins with \p c. \return how much of it is told; 0 if it is none
    std::size_t skipToken(char c)
    {
        const std::size_t start = m_at;
        if (isPlainLetter(c)) {
            while (isPlainLetter(at(0)) || isPlainDigit(at(0)))
                ++m_at;
            return m_at - start;
        }
        if (isPlainDigit(c) || (c == '.' && isPlainDigit(at(1)))) {
            skipNumber();
            return m_at - start;
        }
        if (c == '"' || c == '\'')
            return skipQuoted(c) ? 1 : 0;
        if (c == '[' && (at(1) == '[' || at(1) == '='))
            return 0;
        static constexpr std::string_view signs = "+-*/%^#&~|<>=(){}[];:,.";
        if (signs.find(c) == std::string_view::npos)
            return 0;
        m_at += signLength(c);
        return m_at - start;
    }

    [[nodiscard]] std::size_t signLength(char c) const
    {
        if (c == '.')
            return at(1) != '.' ? 1 : at(2) == '.' ? 3 : 2;
        const bool doubles = c == '=' || c == '/' || c == ':' || c == '<' || c == '>';
        const bool equals = c == '~' || c == '<' || c == '>';
        return (doubles && at(1) == c) || (equals && at(1) == '=') ? 2 : 1;
    }

    /// As Lua does: letters, digits and points, and a sign behind an exponent's letter.
    void skipNumber()
    {
        const bool hex = at(0) == '0' && (at(1) == 'x' || at(1) == 'X');
        for (;; ++m_at) {
            const char lower = static_cast<char>(at(0) | 0x20);
            if (lower == (hex ? 'p' : 'e') && isPlainLetter(at(0))
                && (at(1) == '+' || at(1) == '-'))
                ++m_at;
            else if (!isPlainLetter(at(0)) && !isPlainDigit(at(0)) && at(0) != '.')
                return;
        }
    }

    /// Within one line; \\z would skip the end of it.
    bool skipQuoted(char quote)
    {
        for (++m_at; m_at < m_text.size(); ++m_at) {
            const char c = m_text[m_at];
            if (c == quote) {
                ++m_at;
                return true;
            }
            if (c == '\\')
                ++m_at;
            if (at(0) == '\n' || at(0) == '\r' || (c == '\\' && at(0) == 'z'))
                return false;
        }
        return false;
    }

    /// To the end of the line; other ends than \\n, and brackets, are left to Lua.
    bool skipComment()
    {
        m_at += 2;
        const bool isLong = at(0) == '[' && (at(1) == '[' || at(1) == '=');
        const std::size_t end = m_text.find('\n', m_at);
        const std::string_view comment =
            m_text.substr(m_at, (end == std::string_view::npos ? m_text.size() : end) - m_at);
        m_at += comment.size();
        return !isLong && comment.find('\r') == std::string_view::npos;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

} // namespace

bool readPlainTokens(std::string_view text, PlainTokens &tokens)
{
    return PlainReader(text).read(tokens);
}

} // namespace cradle
