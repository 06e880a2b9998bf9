// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/lua_lexer.h"

#include "tasks/script/lua_tokens.h"
#include "views/code/lua_indent.h"
#include "views/code/run_marks.h"

#include <Qsci/qsciscintilla.h>

#include <cstring>

namespace cradle {

namespace {

/// \param next  what follows the token, past spaces
LuaLexer::Style styleOf(const LuaToken &token, QByteArrayView text, char next)
{
    switch (token.kind) {
    case LuaToken::Kind::Comment:
        return LuaLexer::Comment;
    case LuaToken::Kind::Keyword:
        return LuaLexer::Keyword;
    case LuaToken::Kind::Constant:
    case LuaToken::Kind::Number:
        return LuaLexer::Constant;
    case LuaToken::Kind::String:
        return LuaLexer::String;
    case LuaToken::Kind::Sign:
        return LuaLexer::Plain;
    case LuaToken::Kind::Name:
        break;
    }
    if (token.in(text) == "circle1")
        return LuaLexer::Circle1;
    if (token.in(text) == "circle2")
        return LuaLexer::Circle2;
    return next == '(' ? LuaLexer::Call : LuaLexer::Plain;
}

/// Signs that some fonts join to one with what follows; brackets keep one style, or they would not
/// be matched.
bool joins(char sign)
{
    return std::strchr("<>=~.-/*+:", sign) != nullptr;
}

} // namespace

LuaLexer::LuaLexer(QsciScintilla *editor)
    : QsciLexerCustom(editor)
{
}

void LuaLexer::setLook(const CodeColours &colours, const QFont &font)
{
    setDefaultColor(colours.text);
    setDefaultPaper(colours.background);
    setDefaultFont(font);
    const std::pair<Style, QColor> table[] = {
        {Plain, colours.text},        {Comment, colours.muted},   {Keyword, colours.keyword},
        {Constant, colours.constant}, {String, colours.string},   {Call, colours.call},
        {Circle1, colours.circle1},   {Circle2, colours.circle2}, {Sign, colours.text},
        {Dash, colours.muted},
    };
    for (const auto &[style, colour] : table) {
        setColor(colour, style);
        setPaper(colours.background, style);
        setFont(font, style);
    }
}

QString LuaLexer::description(int style) const
{
    // Names for the lexer's own bookkeeping, which nobody sees.
    return style < StyleCount ? QStringLiteral("style %1").arg(style) : QString();
}

const char *LuaLexer::wordCharacters() const
{
    return "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";
}

/// Programs are short: all of one is styled at once, so that long comments need no state.
void LuaLexer::styleText(int, int)
{
    const QByteArray text = editor()->text().toUtf8();
    const std::vector<LuaToken> tokens = luaTokens(text);
    startStyling(0);
    qsizetype at = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const LuaToken &token = tokens[i];
        const char next = i + 1 < tokens.size() ? text[tokens[i + 1].start] : '\0';
        if (token.start > at)
            setStyling(static_cast<int>(token.start - at), Plain);
        if (token.kind == LuaToken::Kind::Sign) {
            for (qsizetype k = 0; k < token.length; ++k)
                setStyling(1, joins(text[token.start + k]) && (token.start + k) % 2 != 0 ? Sign
                                                                                         : Plain);
        } else if (token.kind == LuaToken::Kind::Comment) {
            styleComment(token.in(text));
        } else {
            setStyling(static_cast<int>(token.length), styleOf(token, text, next));
        }
        at = token.end();
    }
    if (at < text.size())
        setStyling(static_cast<int>(text.size() - at), Plain);
    fold(text);
}

/// Dashes that the font has joined stand one letter too far left before words from the right, where
/// the first is lost in the margin.
void LuaLexer::styleComment(QByteArrayView comment)
{
    qsizetype dashes = 0;
    if (needsRunMarks(QString::fromUtf8(comment))) {
        for (; dashes < comment.size() && comment[dashes] == '-'; ++dashes)
            setStyling(1, dashes % 2 == 0 ? Dash : Comment);
    }
    setStyling(static_cast<int>(comment.size() - dashes), Comment);
}

void LuaLexer::fold(const QByteArray &text)
{
    unsigned long line = 0;
    for (const LuaFold &each : luaFolds(text)) {
        const int level = QsciScintillaBase::SC_FOLDLEVELBASE + each.depth;
        const int flag = each.header ? QsciScintillaBase::SC_FOLDLEVELHEADERFLAG : 0;
        if (editor()->SendScintilla(QsciScintillaBase::SCI_GETFOLDLEVEL, line) != (level | flag))
            editor()->SendScintilla(QsciScintillaBase::SCI_SETFOLDLEVEL, line, long(level | flag));
        ++line;
    }
}

} // namespace cradle
