// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/error_message.h"

#include "tasks/script/lua_message.h"
#include "tasks/script/meant.h"
#include "tasks/script/other_language.h"
#include "tasks/script/script_limits.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace cradle {

namespace {

constexpr std::size_t longestMessage = 2000; ///< bytes of an error that are shown

struct MessageText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

void explainGrammar(ProgramError &error, const QString &message, const QString &source)
{
    if (message.contains(QLatin1String("stack overflow"))) {
        error.message = MessageText::tr("parentheses, blocks or terms are nested too deeply");
        return;
    }
    error.message = plainSyntaxMessage(message);
    const GrammarHint hint = otherLanguage(source, error.line, message);
    if (hint.text.isEmpty())
        return;
    error.message = hint.text + QStringLiteral(" (%1)").arg(error.message);
    error.line = hint.line;
}

} // namespace

ProgramError errorAtTop(lua_State *L, int status, const QString &source)
{
    ProgramError error;
    if (status == LUA_ERRMEM) {
        error.kind = ProgramError::Kind::Memory;
        error.message = MessageText::tr("the program needs more than %1 MiB of memory; is there a "
                                        "table or a text that grows without end?")
                            .arg(limits::scriptBytes / (1024 * 1024));
        return error;
    }
    error.kind = status == LUA_ERRSYNTAX ? ProgramError::Kind::Syntax : ProgramError::Kind::Runtime;
    if (lua_type(L, -1) != LUA_TSTRING) {
        error.message = MessageText::tr("the program called error with %1").arg(nameValue(L, -1));
        return error;
    }
    std::size_t size = 0;
    const char *text = lua_tolstring(L, -1, &size);
    QString message = QString::fromUtf8(
        text, static_cast<qsizetype>(std::min<std::size_t>(size, longestMessage)));
    static const QRegularExpression place(QStringLiteral("^(lab\\.lua|table\\.sort):(\\d+): "));
    if (const auto match = place.match(message); match.hasMatch()) {
        if (match.captured(1) == QLatin1String("lab.lua"))
            error.line = match.captured(2).toInt();
        message = message.mid(match.capturedLength());
    }
    for (QChar &letter : message) {
        // A message is a line on a terminal, too.
        if (letter.category() == QChar::Other_Control || letter == QChar::ReplacementCharacter)
            letter = QLatin1Char(' ');
    }
    if (message.startsWith(QLatin1String("attempt to load a binary chunk")))
        message = MessageText::tr("this is no text, so it is no program");
    if (status != LUA_ERRSYNTAX)
        error.message =
            plainRuntimeMessage(message) + meantAtRunTime(L, message, error.line, source);
    else
        explainGrammar(error, message, source);
    return error;
}

} // namespace cradle
