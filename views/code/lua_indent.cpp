// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/lua_indent.h"

#include "tasks/script/lua_tokens.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

template <std::size_t N>
bool isOneOf(QByteArrayView word, const std::array<QByteArrayView, N> &words)
{
    return std::ranges::find(words, word) != words.end();
}

bool opens(QByteArrayView word)
{
    // A for or while opens by its do.
    static constexpr std::array<QByteArrayView, 6> words{"function", "if", "do",
                                                         "repeat",   "{",  "("};
    return isOneOf(word, words);
}

bool closes(QByteArrayView word)
{
    static constexpr std::array<QByteArrayView, 4> words{"end", "until", "}", ")"};
    return isOneOf(word, words);
}

bool reopens(QByteArrayView word)
{
    static constexpr std::array<QByteArrayView, 2> words{"else", "elseif"};
    return isOneOf(word, words);
}

bool isCode(const LuaToken &token)
{
    return token.kind == LuaToken::Kind::Keyword || token.kind == LuaToken::Kind::Sign;
}

qsizetype lineStart(QByteArrayView text, qsizetype at)
{
    const qsizetype newline = at > 0 ? text.lastIndexOf('\n', at - 1) : -1;
    return newline + 1;
}

int indentOfLine(QByteArrayView text, qsizetype start)
{
    int indent = 0;
    while (start + indent < text.size() && text[start + indent] == ' ')
        ++indent;
    return indent;
}

/// The starts of the lines in which the blocks that are open at the end of \p text begin; what
/// the last token closes is put into \p closed.
std::vector<qsizetype> openBlocks(QByteArrayView text, std::optional<qsizetype> *closed = nullptr)
{
    std::vector<qsizetype> open;
    for (const LuaToken &token : luaTokens(text)) {
        const QByteArrayView word = token.in(text);
        if (closed)
            closed->reset();
        if (!isCode(token))
            continue;
        if ((closes(word) || reopens(word)) && !open.empty()) {
            if (closed)
                *closed = open.back();
            open.pop_back();
        }
        if (opens(word) || reopens(word))
            open.push_back(lineStart(text, token.start));
    }
    return open;
}

} // namespace

int indentAfter(QByteArrayView before)
{
    qsizetype last = before.size();
    while (last > 0 && QByteArrayView(" \t\r\n").contains(before[last - 1]))
        --last;
    const qsizetype start = lineStart(before, last);
    const std::vector<qsizetype> open = openBlocks(before);
    const bool deeper = !open.empty() && open.back() == start;
    return indentOfLine(before, start) + (deeper ? luaIndent : 0);
}

std::optional<int> indentOfCloser(QByteArrayView before)
{
    const qsizetype start = lineStart(before, before.size());
    const QByteArrayView line = before.sliced(start).trimmed();
    if (!closes(line) && !reopens(line))
        return std::nullopt;
    std::optional<qsizetype> closed;
    openBlocks(before, &closed);
    if (!closed)
        return std::nullopt;
    return indentOfLine(before, *closed);
}

std::vector<LuaFold> luaFolds(QByteArrayView text)
{
    std::vector<LuaFold> folds(static_cast<std::size_t>(text.count('\n')) + 1);
    std::size_t line = 0;
    qsizetype at = 0;
    int depth = 0;
    int before = 0; // of the line, at its start
    const auto finish = [&] {
        folds[line] = {std::min(before, depth), depth > before};
        before = depth;
        ++line;
    };
    for (const LuaToken &token : luaTokens(text)) {
        for (; at < token.start; ++at) {
            if (text[at] == '\n')
                finish();
        }
        if (isCode(token) && opens(token.in(text)))
            ++depth;
        else if (isCode(token) && closes(token.in(text)))
            depth = std::max(0, depth - 1);
    }
    for (; at < text.size(); ++at) {
        if (text[at] == '\n')
            finish();
    }
    finish();
    return folds;
}

} // namespace cradle
