// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_message.h"

#include "tasks/script/kept_pattern.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <span>

namespace cradle {

namespace {

struct LuaMessageText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// A message of Lua: what it looks like, and what it says, to be translated.
struct Form {
    const char *pattern;
    const char *text;
};

// clang-format off
constexpr Form syntaxForms[] = {
    {"'(.+)' expected \\(to close '(.+)' at line (\\d+)\\) near (.+)", QT_TRANSLATE_NOOP("Script", "'%1' expected (to close '%2' at line %3) near %4")},
    {"(.+) expected near (.+)", QT_TRANSLATE_NOOP("Script", "%1 expected near %2")},
    {"unexpected symbol near (.+)", QT_TRANSLATE_NOOP("Script", "unexpected symbol near %1")},
    {"syntax error near (.+)", QT_TRANSLATE_NOOP("Script", "syntax error near %1")},
    {"unfinished string near (.+)", QT_TRANSLATE_NOOP("Script", "unfinished string near %1")},
    {"unfinished long string \\(starting at line (\\d+)\\) near .+", QT_TRANSLATE_NOOP("Script", "unfinished long string (starting at line %1)")},
    {"unfinished long comment \\(starting at line (\\d+)\\) near .+", QT_TRANSLATE_NOOP("Script", "unfinished long comment (starting at line %1)")},
    {"malformed number near (.+)", QT_TRANSLATE_NOOP("Script", "malformed number near %1")},
    {"invalid escape sequence near (.+)", QT_TRANSLATE_NOOP("Script", "invalid escape sequence near %1")},
    {"break outside (?:a )?loop at line (\\d+).*", QT_TRANSLATE_NOOP("Script", "break outside loop at line %1")},
    {"no visible label '(.+)' for <?goto>? at line (\\d+)", QT_TRANSLATE_NOOP("Script", "no visible label '%1' for goto at line %2")},
    {"label '(.+)' already defined on line (\\d+)", QT_TRANSLATE_NOOP("Script", "label '%1' already defined on line %2")},
    {"attempt to assign to const variable '(.+)'", QT_TRANSLATE_NOOP("Script", "attempt to assign to const variable '%1'")},
};

constexpr Form runtimeForms[] = {
    {"attempt to compare two (\\w+) values", QT_TRANSLATE_NOOP("Script", "attempt to compare two %1 values")},
    {"attempt to compare (\\w+) with (\\w+)", QT_TRANSLATE_NOOP("Script", "attempt to compare %1 with %2")},
    {"attempt to (?:divide by zero|perform 'n//0')", QT_TRANSLATE_NOOP("Script", "attempt to divide a whole number by zero")},
    {"attempt to perform 'n%+0'", QT_TRANSLATE_NOOP("Script", "attempt to take the rest of a division by zero")},
    {"attempt to \\w+ an? '(\\w+)' with an? '(\\w+)'", QT_TRANSLATE_NOOP("Script", "%1 and %2 are no two numbers to calculate with")},
    {"bad argument #(\\d+) to '(.+)' \\((\\w+) expected, got (.+)\\)", QT_TRANSLATE_NOOP("Script", "bad argument #%1 to '%2' (%3 expected, got %4)")},
    {"bad argument #(\\d+) to '(.+)' \\(number has no integer representation\\)", QT_TRANSLATE_NOOP("Script", "bad argument #%1 to '%2' (number has no integer representation)")},
    {"bad argument #(\\d+) to '(.+)' \\((?:interval is empty|out of range|position out of bounds)\\)", QT_TRANSLATE_NOOP("Script", "bad argument #%1 to '%2' (out of range)")},
    {"number(?: \\(.*\\))? has no integer representation", QT_TRANSLATE_NOOP("Script", "number has no integer representation")},
    {"(?:bad )?'for' initial value (?:must be a number|\\(number expected.*)", QT_TRANSLATE_NOOP("Script", "the first value of 'for' must be a number")},
    {"(?:bad )?'for' limit (?:must be a number|\\(number expected.*)", QT_TRANSLATE_NOOP("Script", "the last value of 'for' must be a number")},
    {"(?:bad )?'for' step (?:must be a number|\\(number expected.*)", QT_TRANSLATE_NOOP("Script", "the step of 'for' must be a number")},
    {"'for' step is zero", QT_TRANSLATE_NOOP("Script", "the step of 'for' is zero")},
    {"assertion failed!", QT_TRANSLATE_NOOP("Script", "assertion failed!")},
};
// clang-format on

/// A word that Lua writes for a part of the program.
QString partName(const QString &part)
{
    //: the end of the program
    if (part == QLatin1String("<eof>"))
        return LuaMessageText::tr("<eof>");
    if (part == QLatin1String("<name>"))
        return LuaMessageText::tr("<name>");
    return part;
}

/// The message by the first form that it has.
QString translated(const QString &message, std::span<const Form> forms)
{
    for (const Form &form : forms) {
        const QRegularExpressionMatch match =
            keptPattern(QRegularExpression::anchoredPattern(QLatin1String(form.pattern)))
                .match(message);
        if (!match.hasMatch())
            continue;
        // All at once: what the program is called may have a %1 of its own.
        QString text = LuaMessageText::tr(form.text);
        QString result;
        for (qsizetype i = 0; i < text.size(); ++i) {
            const int number = i + 1 < text.size() ? text.at(i + 1).digitValue() : -1;
            if (text.at(i) == QLatin1Char('%') && number >= 1
                && number <= match.lastCapturedIndex()) {
                result += partName(match.captured(number));
                ++i;
            } else {
                result += text.at(i);
            }
        }
        return result;
    }
    return message;
}

/// "local 'x'", "field 'x'", "global 'x'" of Lua's messages: the name.
QString nameIn(const QString &message)
{
    static const QRegularExpression pattern(
        QStringLiteral("\\((?:local|field|global|upvalue|method|constant) '([^']*)'\\)"));
    const QString name = pattern.match(message).captured(1);
    return name == QLatin1String("?") || name == QLatin1String("integer index") ? QString() : name;
}

QString typeIn(const QString &message, const QString &verb)
{
    return keptPattern(verb + QStringLiteral(" (?:a |an )?(\\w+) value"))
        .match(message)
        .captured(1);
}

} // namespace

QString plainSyntaxMessage(const QString &message)
{
    return translated(message, syntaxForms);
}

QString plainRuntimeMessage(const QString &message)
{
    const QString name = nameIn(message);
    const QString what =
        name.isEmpty() ? LuaMessageText::tr("this value") : QStringLiteral("`%1`").arg(name);
    const auto type = [&](const char *verb) { return typeIn(message, QLatin1String(verb)); };
    if (const QString found = type("attempt to index"); !found.isEmpty())
        return LuaMessageText::tr("%1 is %2, so it has no fields").arg(what, found);
    if (const QString found = type("attempt to call"); !found.isEmpty())
        return LuaMessageText::tr("%1 is %2, not a function that can be called").arg(what, found);
    if (const QString found = type("attempt to perform arithmetic on"); !found.isEmpty())
        return LuaMessageText::tr("%1 is %2, not a number to calculate with").arg(what, found);
    if (const QString found = type("attempt to concatenate"); !found.isEmpty())
        return LuaMessageText::tr("%1 is %2, so .. cannot join it to a text").arg(what, found);
    if (const QString found = type("attempt to get length of"); !found.isEmpty())
        return LuaMessageText::tr("%1 is %2, so it has no length").arg(what, found);
    QString text = translated(message, runtimeForms);
    if (message.startsWith(QLatin1String("attempt to compare")))
        return LuaMessageText::tr(
                   "%1; only numbers compare with numbers (the length of a vector is "
                   "v:length())")
            .arg(text);
    if (message.contains(QLatin1String("stack overflow")))
        return LuaMessageText::tr("a function calls itself without end (stack overflow)");
    return text;
}

} // namespace cradle
