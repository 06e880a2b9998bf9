// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lua_tokens.h"

#include <QRegularExpression>
#include <QStringList>

namespace cradle {

namespace {

bool isKeyword(const QString &word)
{
    static const QStringList words{
        QStringLiteral("and"),   QStringLiteral("break"),  QStringLiteral("do"),
        QStringLiteral("else"),  QStringLiteral("elseif"), QStringLiteral("end"),
        QStringLiteral("false"), QStringLiteral("for"),    QStringLiteral("function"),
        QStringLiteral("goto"),  QStringLiteral("if"),     QStringLiteral("in"),
        QStringLiteral("local"), QStringLiteral("nil"),    QStringLiteral("not"),
        QStringLiteral("or"),    QStringLiteral("repeat"), QStringLiteral("return"),
        QStringLiteral("then"),  QStringLiteral("true"),   QStringLiteral("until"),
        QStringLiteral("while")};
    return words.contains(word);
}

} // namespace

std::vector<ProgramToken> luaTokens(const QString &source)
{
    // White space and comments; long texts; short texts; numbers; names; signs.
    static const QRegularExpression pattern(QStringLiteral(
        R"re((\s+|--\[(=*)\[[\s\S]*?\]\2\]|--[^\n]*))re"
        R"re(|(\[(=*)\[[\s\S]*?\]\4\]|"(?:\\[\s\S]|[^"\\\n])*"|'(?:\\[\s\S]|[^'\\\n])*'))re"
        R"re(|(0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))re"
        R"re(|([A-Za-z_]\w*))re"
        R"re(|(\.\.\.|\.\.|==|~=|<=|>=|//|::|<<|>>|[^\s\w]))re"));
    std::vector<ProgramToken> tokens;
    int line = 1;
    auto match = pattern.globalMatch(source);
    while (match.hasNext()) {
        const QRegularExpressionMatch found = match.next();
        const QString text = found.captured();
        if (found.capturedStart(1) < 0) {
            ProgramToken token;
            token.text = text;
            token.start = found.capturedStart();
            token.line = line;
            if (found.capturedStart(3) >= 0)
                token.kind = ProgramToken::Kind::Text;
            else if (found.capturedStart(5) >= 0)
                token.kind = ProgramToken::Kind::Number;
            else if (found.capturedStart(6) >= 0)
                token.kind =
                    isKeyword(text) ? ProgramToken::Kind::Keyword : ProgramToken::Kind::Name;
            tokens.push_back(token);
        }
        line += static_cast<int>(text.count(QLatin1Char('\n')));
    }
    return tokens;
}

} // namespace cradle
