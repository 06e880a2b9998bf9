// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/local_names.h"

#include "tasks/script/lua_tokens.h"

namespace cradle {

namespace {

/// Goes through the tokens once, with the blocks that are open.
class NameReader
{
public:
    explicit NameReader(QByteArrayView text)
        : m_text(text)
    {
        int line = 1;
        qsizetype at = 0;
        for (const LuaToken &token : luaTokens(text)) {
            line += static_cast<int>(text.sliced(at, token.start - at).count('\n'));
            at = token.start;
            if (token.kind == LuaToken::Kind::Comment)
                continue;
            m_tokens.push_back(token);
            m_lines.push_back(line);
        }
    }

    std::vector<LocalName> read()
    {
        m_open.emplace_back(); // the file itself
        while (m_at < m_tokens.size())
            readToken();
        while (!m_open.empty())
            close(m_lines.empty() ? 1 : m_lines.back());
        return std::move(m_names);
    }

private:
    [[nodiscard]] QByteArrayView word(std::size_t at) const
    {
        return at < m_tokens.size() ? m_tokens[at].in(m_text) : QByteArrayView();
    }
    [[nodiscard]] bool isName(std::size_t at) const
    {
        return at < m_tokens.size() && m_tokens[at].kind == LuaToken::Kind::Name;
    }

    void readToken()
    {
        const QByteArrayView now = word(m_at);
        const int line = m_lines[m_at];
        ++m_at;
        if (now == "local") {
            if (word(m_at) == "function") {
                declare(++m_at);
                readFunction();
            } else {
                declareList();
            }
        } else if (now == "function") {
            readFunction();
        } else if (now == "for") {
            m_open.emplace_back();
            m_waitsForDo = true;
            declareList();
        } else if (now == "while") {
            m_open.emplace_back();
            m_waitsForDo = true;
        } else if (now == "do" && m_waitsForDo) {
            m_waitsForDo = false;
        } else if (now == "if" || now == "repeat" || now == "do") {
            m_open.emplace_back();
        } else if (now == "else" || now == "elseif") {
            close(line);
            m_open.emplace_back();
        } else if (now == "end" || now == "until") {
            close(line);
        }
        if (m_open.empty())
            m_open.emplace_back(); // an `end` too many
    }

    void readFunction()
    {
        while (m_at < m_tokens.size() && word(m_at) != "(")
            ++m_at;
        m_open.emplace_back();
        ++m_at;
        declareList();
    }

    /// a, b <const>, c
    void declareList()
    {
        while (isName(m_at)) {
            declare(m_at);
            ++m_at;
            if (word(m_at) == "<")
                m_at += 3;
            if (word(m_at) != ",")
                return;
            ++m_at;
        }
    }

    void declare(std::size_t at)
    {
        if (!isName(at))
            return;
        m_open.back().push_back(m_names.size());
        m_names.push_back({.name = QString::fromUtf8(word(at)),
                           .line = m_lines[at],
                           .isOutermost = m_open.size() == 1});
    }

    void close(int line)
    {
        for (const std::size_t index : m_open.back())
            m_names[index].lastLine = line;
        m_open.pop_back();
    }

    QByteArrayView m_text;
    std::vector<LuaToken> m_tokens;
    std::vector<int> m_lines; ///< of each token
    std::size_t m_at = 0;
    bool m_waitsForDo = false;
    std::vector<std::vector<std::size_t>> m_open; ///< the names of each block
    std::vector<LocalName> m_names;
};

} // namespace

std::vector<LocalName> localNames(const QString &source)
{
    const QByteArray text = source.toUtf8();
    return NameReader(text).read();
}

} // namespace cradle
