// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/asked_fields.h"

#include "tasks/script/program_tokens.h"

#include <algorithm>

namespace cradle {

namespace {

using Tokens = std::vector<ProgramToken>;

bool isAny(const ProgramToken &token, std::initializer_list<const char *> words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](const char *word) { return token.is(word); });
}

/// Whether the field whose name is at \p name is assigned, alone or as one of several.
bool isSet(const Tokens &tokens, std::size_t name)
{
    for (std::size_t i = name + 1; i < tokens.size(); ++i) {
        if (tokens[i].is("="))
            return true;
        // In a list of places there are names, numbers and their signs only.
        if (i == name + 1 ? !tokens[i].is(",")
                          : !tokens[i].endsOperand() && !isAny(tokens[i], {",", ".", "["}))
            return false;
    }
    return false;
}

/// Where what has the field at \p name begins: `circles[i]` of `circles[i].mass`.
std::size_t ownerOf(const Tokens &tokens, std::size_t name)
{
    std::size_t begin = name;
    int open = 0;
    while (begin > 0) {
        const ProgramToken &before = tokens[begin - 1];
        open += before.is("]") ? 1 : before.is("[") ? -1 : 0;
        if (open == 0 && !before.is("[") && !before.is(".")
            && before.kind != ProgramToken::Kind::Name)
            break;
        // Two names side by side are two statements.
        if (open == 0 && before.kind == ProgramToken::Kind::Name
            && !isAny(tokens[begin], {".", "["}))
            break;
        --begin;
    }
    return begin;
}

bool isAsked(const Tokens &tokens, std::size_t name)
{
    const std::size_t begin = ownerOf(tokens, name);
    if (begin > 0 && isAny(tokens[begin - 1], {"not", "==", "~="}))
        return true;
    return name + 1 < tokens.size() && isAny(tokens[name + 1], {"or", "and", "then", "==", "~="});
}

} // namespace

AskedFields::AskedFields(const QString &source)
{
    const Tokens tokens = programTokens(source);
    std::set<QString> written;
    for (const bool isLook : {false, true}) {
        for (std::size_t i = 1; i < tokens.size(); ++i) {
            if (tokens[i].kind != ProgramToken::Kind::Name || !tokens[i - 1].is("."))
                continue;
            if (!isLook && isSet(tokens, i))
                written.insert(tokens[i].text);
            if (isLook && written.contains(tokens[i].text) && isAsked(tokens, i))
                m_asked.insert({tokens[i].line, tokens[i].text});
        }
    }
}

} // namespace cradle
