// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/script_source.h"

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

} // namespace

int parse(lua_State *L, const QString &source)
{
    const QByteArray text = source.toUtf8();
    const int status = luaL_loadbufferx(L, text.constData(), static_cast<std::size_t>(text.size()),
                                        "=lab.lua", "t");
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

void addHint(ProgramError &error, const QString &source)
{
    if (error.kind != ProgramError::Kind::Syntax || error.line < 1)
        return;
    const QString hint =
        otherLanguage(source.section(QLatin1Char('\n'), error.line - 1, error.line - 1));
    if (!hint.isEmpty())
        error.message = hint + QStringLiteral(" (%1)").arg(error.message);
}

std::optional<ProgramError> hiddenEntry(const QString &source)
{
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

QString otherLanguage(const QString &line)
{
    const QString code = line.section(QStringLiteral("--"), 0, 0);
    static const QRegularExpression compound(QStringLiteral("([\\w.]+)\\s*([-+*/])=\\s*(.*\\S)"));
    static const QRegularExpression unequal(QStringLiteral("!="));
    static const QRegularExpression increment(QStringLiteral("(\\w+)\\+\\+"));
    static const QRegularExpression comment(QStringLiteral("^\\s*(//|/\\*|#)"));
    static const QRegularExpression assigned(
        QStringLiteral("\\b(?:if|while|elseif)\\b[^=<>~]*[^=<>~]=[^=]"));
    static const QRegularExpression compared(QStringLiteral("^\\s*[\\w.]+\\s*==\\s*"));
    static const QRegularExpression letters(QStringLiteral("[^\\x00-\\x7F]"));
    if (const auto m = compound.match(code); m.hasMatch())
        return SourceText::tr("Lua has no %2=; write %1 = %1 %2 %3")
            .arg(m.captured(1), m.captured(2), m.captured(3));
    if (unequal.match(code).hasMatch())
        return SourceText::tr("\"not equal\" is ~= in Lua, not !=");
    if (const auto m = increment.match(code); m.hasMatch())
        return SourceText::tr("Lua has no ++; write %1 = %1 + 1").arg(m.captured(1));
    if (comment.match(code).hasMatch())
        return SourceText::tr("a comment begins with -- in Lua");
    if (code.contains(QLatin1String("&&")) || code.contains(QLatin1String("||")))
        return SourceText::tr("Lua writes `and`, `or`, `not` in words");
    if (assigned.match(code).hasMatch())
        return SourceText::tr("= assigns; to compare write ==");
    if (compared.match(code).hasMatch())
        return SourceText::tr("== compares; to assign write =");
    if (letters.match(code).hasMatch())
        return SourceText::tr("names have the letters a to z, digits and _ only");
    return {};
}

std::optional<ProgramError> findSyntaxError(const QString &source)
{
    if (auto error = tooLong(source))
        return error;
    LuaMemory memory(limits::scriptBytes);
    const LuaState state = newLuaState(memory);
    if (!state)
        return noMemory();
    memory.hold(state.get());
    const int status = parse(state.get(), source);
    memory.release();
    if (status == LUA_OK)
        return hiddenEntry(source);
    ProgramError error = errorAtTop(state.get(), status);
    addHint(error, source);
    return error;
}

} // namespace cradle
