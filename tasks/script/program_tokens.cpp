// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/program_tokens.h"

#include "tasks/script/lua_tokens.h"

namespace cradle {

namespace {

ProgramToken::Kind kindOf(LuaToken::Kind kind)
{
    switch (kind) {
    case LuaToken::Kind::Keyword:
    case LuaToken::Kind::Constant:
        return ProgramToken::Kind::Keyword;
    case LuaToken::Kind::Name:
        return ProgramToken::Kind::Name;
    case LuaToken::Kind::Number:
        return ProgramToken::Kind::Number;
    case LuaToken::Kind::String:
        return ProgramToken::Kind::Text;
    case LuaToken::Kind::Comment:
    case LuaToken::Kind::Sign:
        break;
    }
    return ProgramToken::Kind::Sign;
}

} // namespace

std::vector<ProgramToken> programTokens(const QString &source)
{
    const QByteArray bytes = source.toUtf8();
    std::vector<ProgramToken> tokens;
    // A letter beyond ASCII is more than one byte.
    qsizetype byte = 0;
    qsizetype letter = 0;
    int line = 1;
    const auto goTo = [&](qsizetype to) {
        const QByteArrayView between = QByteArrayView(bytes).sliced(byte, to - byte);
        letter += QString::fromUtf8(between).size();
        line += static_cast<int>(between.count('\n'));
        byte = to;
    };
    for (const LuaToken &token : luaTokens(bytes)) {
        goTo(token.start);
        if (token.kind != LuaToken::Kind::Comment)
            tokens.push_back({.kind = kindOf(token.kind),
                              .text = QString::fromUtf8(token.in(bytes)),
                              .start = letter,
                              .line = line});
    }
    return tokens;
}

} // namespace cradle
