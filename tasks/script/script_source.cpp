// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/script_source.h"

#include "tasks/script/chunk_cache.h"
#include "tasks/script/error_message.h"
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
    const auto before = QStringView(source).left(match.capturedStart(1));
    return ProgramError{.message = SourceText::tr("`%1` is local here, so nobody can call it; "
                                                  "write function %1(…) without local")
                                       .arg(match.captured(1)),
                        .kind = ProgramError::Kind::Syntax,
                        .line = static_cast<int>(before.count(QLatin1Char('\n'))) + 1};
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
        return hiddenEntry(source);
    return errorAtTop(state, status, source);
}

} // namespace cradle
