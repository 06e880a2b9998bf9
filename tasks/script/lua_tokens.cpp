// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_tokens.h"

#include <QByteArray>

#include <algorithm>

namespace cradle {

namespace {

using Kind = LuaToken::Kind;

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Letters beyond ASCII are no letters to Lua; shown as part of the name all the same.
bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'
           || static_cast<unsigned char>(c) >= 0x80;
}

/// Reads one token after another.
class LuaReader final
{
public:
    explicit LuaReader(QByteArrayView text)
        : m_text(text)
    {
    }

    LuaToken next()
    {
        LuaToken token;
        token.start = m_at;
        const char c = at(0);
        if (c == '-' && at(1) == '-') {
            token.kind = Kind::Comment;
            token.open = skipComment();
        } else if (c == '"' || c == '\'') {
            token.kind = Kind::String;
            token.open = skipQuoted(c);
        } else if (c == '[' && bracketLevel() >= 0) {
            token.kind = Kind::String;
            token.open = skipBracket(bracketLevel());
        } else if (isLetter(c)) {
            skipWhile([](char each) { return isLetter(each) || isDigit(each); });
            token.kind = kindOf(m_text.sliced(token.start, m_at - token.start));
        } else if (isDigit(c) || (c == '.' && isDigit(at(1)))) {
            token.kind = Kind::Number;
            skipNumber();
        } else {
            m_at += signLength();
        }
        token.length = m_at - token.start;
        return token;
    }

    bool skipSpace()
    {
        skipWhile([](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
        return m_at < m_text.size();
    }

private:
    [[nodiscard]] char at(qsizetype ahead) const
    {
        return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
    }

    template <typename Wanted>
    void skipWhile(Wanted wanted)
    {
        while (m_at < m_text.size() && wanted(m_text[m_at]))
            ++m_at;
    }

    static Kind kindOf(QByteArrayView word)
    {
        if (word == "true" || word == "false" || word == "nil")
            return Kind::Constant;
        return std::ranges::find(luaKeywords(), word) != luaKeywords().end() ? Kind::Keyword
                                                                             : Kind::Name;
    }

    /// Of the sign here: 3 of "...", 2 of "<=".
    [[nodiscard]] qsizetype signLength() const
    {
        if (at(0) == '.' && at(1) == '.')
            return at(2) == '.' ? 3 : 2;
        const char pair[] = {at(0), at(1)};
        static const std::vector<QByteArrayView> pairs{
            "==", "~=", "<=", ">=", "//", "::", "<<", ">>"};
        return std::ranges::find(pairs, QByteArrayView(pair, 2)) != pairs.end() ? 2 : 1;
    }

    /// The number of = in [==[ here, or -1 if there is none.
    [[nodiscard]] int bracketLevel() const
    {
        int level = 0;
        while (at(level + 1) == '=')
            ++level;
        return at(0) == '[' && at(level + 1) == '[' ? level : -1;
    }

    bool skipBracket(int level)
    {
        const QByteArray close = ']' + QByteArray(level, '=') + ']';
        const qsizetype found = m_text.indexOf(close, m_at + level + 2);
        m_at = found < 0 ? m_text.size() : found + close.size();
        return found < 0;
    }

    bool skipComment()
    {
        m_at += 2;
        if (at(0) == '[' && bracketLevel() >= 0)
            return skipBracket(bracketLevel());
        skipWhile([](char c) { return c != '\n'; });
        return m_at == m_text.size();
    }

    bool skipQuoted(char quote)
    {
        ++m_at;
        while (m_at < m_text.size() && m_text[m_at] != '\n') {
            if (m_text[m_at] == quote) {
                ++m_at;
                return false;
            }
            m_at += m_text[m_at] == '\\' ? 2 : 1;
        }
        m_at = std::min(m_at, m_text.size());
        return m_at == m_text.size();
    }

    void skipNumber()
    {
        const bool hex = at(0) == '0' && (at(1) | 0x20) == 'x';
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            const char lower = static_cast<char>(c | 0x20);
            const bool exponent = lower == (hex ? 'p' : 'e');
            if (exponent && (at(1) == '+' || at(1) == '-'))
                ++m_at;
            else if (c == '.' ? at(1) == '.' : !isDigit(c) && !isLetter(c))
                return; // 1..2 joins two numbers
            ++m_at;
        }
    }

    QByteArrayView m_text;
    qsizetype m_at = 0;
};

} // namespace

std::vector<LuaToken> luaTokens(QByteArrayView text)
{
    std::vector<LuaToken> tokens;
    LuaReader reader(text);
    while (reader.skipSpace())
        tokens.push_back(reader.next());
    return tokens;
}

const std::vector<QByteArrayView> &luaKeywords()
{
    static const std::vector<QByteArrayView> words{
        "and", "break", "do",  "else", "elseif", "end",    "for",  "function", "goto", "if",
        "in",  "local", "not", "or",   "repeat", "return", "then", "until",    "while"};
    return words;
}

} // namespace cradle
