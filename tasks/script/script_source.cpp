// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/script_source.h"

#include "tasks/script/chunk_cache.h"
#include "tasks/script/error_message.h"
#include "tasks/script/lua_tokens.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/student_script.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace cradle {

namespace {

struct SourceText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// What is before the last word, if that is \p word, and without the space there.
std::optional<QStringView> beforeWord(QStringView text, QLatin1String word)
{
    if (!text.endsWith(word))
        return std::nullopt;
    text.chop(word.size());
    while (!text.isEmpty() && text.back().isSpace())
        text.chop(1);
    return text;
}

/// Whether `local` or `local function` stands before that name anywhere: a look that costs less
/// than an expression, since programs are read by the hundred.
bool mayBeLocal(const QString &source, QLatin1String name)
{
    for (qsizetype at = source.indexOf(name); at >= 0; at = source.indexOf(name, at + 1)) {
        const QStringView before = QStringView(source).left(at).trimmed();
        const auto function = beforeWord(before, QLatin1String("function"));
        if (beforeWord(function.value_or(before), QLatin1String("local")))
            return true;
    }
    return false;
}

/// The line that follows \p before, from 1.
int lineAfter(QStringView before)
{
    return static_cast<int>(before.count(QLatin1Char('\n'))) + 1;
}

} // namespace

int parse(lua_State *L, const QString &source, bool once)
{
    const QByteArray text = source.toUtf8();
    const int status = once ? readProgram(L, text, "=lab.lua") : loadProgram(L, text, "=lab.lua");
    // Nesting that is too deep for the parser Lua tells as an overflow while running.
    return status == LUA_OK || status == LUA_ERRMEM ? status : LUA_ERRSYNTAX;
}

std::optional<ProgramError> tooLong(const QString &source)
{
    if (source.size() <= limits::sourceBytes)
        return std::nullopt;
    return ProgramError{.message = SourceText::tr("the program has %1 letters; at most %2 are "
                                                  "right")
                                       .arg(source.size())
                                       .arg(limits::sourceBytes),
                        .kind = ProgramError::Kind::Memory};
}

ProgramError noMemory()
{
    return {.message = SourceText::tr("there is no memory to run a program"),
            .kind = ProgramError::Kind::Memory};
}

namespace {

std::optional<ProgramError> hiddenEntry(const QString &source)
{
    if (!mayBeLocal(source, QLatin1String("on_load"))
        && !mayBeLocal(source, QLatin1String("on_update")))
        return std::nullopt;
    static const QRegularExpression local(
        QStringLiteral("^[ \\t]*local\\s+(?:function\\s+)?(on_load|on_update)\\b"),
        QRegularExpression::MultilineOption);
    const QRegularExpressionMatch match = local.match(source);
    if (!match.hasMatch())
        return std::nullopt;
    return ProgramError{.message = SourceText::tr("`%1` is local here, so nobody can call it; "
                                                  "write function %1(…) without local")
                                       .arg(match.captured(1)),
                        .kind = ProgramError::Kind::Syntax,
                        .line = lineAfter(QStringView(source).left(match.capturedStart(1)))};
}

/// The digits that end there.
QStringView digitsBefore(QStringView text)
{
    qsizetype from = text.size();
    while (from > 0 && text[from - 1].isDigit())
        --from;
    return text.sliced(from);
}

/// Whether "= 0,5" stands anywhere; as mayBeLocal(), a look before an expression.
bool mayHaveComma(QStringView source)
{
    for (qsizetype at = source.indexOf(u','); at >= 0; at = source.indexOf(u',', at + 1)) {
        if (at + 1 == source.size() || !source[at + 1].isDigit())
            continue;
        QStringView before = source.first(at);
        before.chop(digitsBefore(before).size());
        if (before.size() < at && before.endsWith(u'-'))
            before.chop(1);
        if (before.size() < at && before.trimmed().endsWith(u'='))
            return true;
    }
    return false;
}

std::optional<ProgramError> decimalComma(const QString &source)
{
    if (!mayHaveComma(source))
        return std::nullopt;
    static const QRegularExpression assigned(
        QStringLiteral("^[ \\t]*(?:local[ \\t]+)?([A-Za-z_][\\w.]*)[ \\t]*=[ \\t]*"
                       "(-?\\d+),(\\d+)[ \\t]*;?[ \\t]*\\r?(?:--.*)?$"),
        QRegularExpression::MultilineOption);
    const QByteArray text = source.toUtf8();
    const std::vector<LuaToken> tokens = luaTokens(text);
    auto matches = assigned.globalMatch(source);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        const QStringView before = QStringView(source).left(match.capturedStart(1));
        const qsizetype at = before.toUtf8().size();
        const auto name = std::find_if(tokens.begin(), tokens.end(),
                                       [at](const LuaToken &token) { return token.start == at; });
        // Not in a comment or a text of several lines, in a table, or as the last of several names.
        if (name == tokens.end())
            continue;
        if (name != tokens.begin() && QByteArrayView(",{").contains(text[(name - 1)->start]))
            continue;
        return ProgramError{
            .message = SourceText::tr("%1 would be %2 here: the comma ends a value; a number has a "
                                      "point, %2.%3")
                           .arg(match.captured(1), match.captured(2), match.captured(3)),
            .kind = ProgramError::Kind::Syntax,
            .line = lineAfter(before)};
    }
    return std::nullopt;
}

} // namespace

std::optional<ProgramError> meantOtherwise(const QString &source)
{
    if (auto error = hiddenEntry(source))
        return error;
    return decimalComma(source);
}

std::optional<ProgramError> findSyntaxError(const QString &source)
{
    if (auto error = tooLong(source))
        return error;
    LuaMemory memory(limits::scriptBytes);
    lua_State *const state = newLuaState(memory);
    if (!state)
        return noMemory();
    memory.hold(state);
    const int status = parse(state, source);
    memory.release();
    if (status == LUA_OK)
        return meantOtherwise(source);
    return errorAtTop(state, status, source);
}

} // namespace cradle
