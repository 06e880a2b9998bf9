// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/meant.h"

#include "tasks/script/local_names.h"
#include "tasks/script/script_host.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <map>

namespace cradle {

namespace {

struct MeantText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

constexpr qint64 lettersPerInstruction = 16; ///< of the program, read for a name

QString lineOf(const QString &source, int line)
{
    return line < 1 ? QString() : source.section(QLatin1Char('\n'), line - 1, line - 1).left(300);
}

/// The value of a number or of a local variable that holds one, where the error was.
std::optional<double> valueOf(const ScriptHost &host, const QString &term)
{
    QString text = term.trimmed();
    for (const ProgramValue &local : host.caught.locals) {
        if (local.name == text)
            text = local.value;
    }
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

/// circles[0] gives nil, as it must where ipairs ends.
QString noSuchCircle(const ScriptHost &host, const QString &message, const QString &line,
                     const QString &source)
{
    static const QRegularExpression here(QStringLiteral("\\bcircles\\s*\\[([^\\]]+)\\]"));
    static const QRegularExpression named(QStringLiteral("\\(local '(\\w+)'\\)"));
    QRegularExpressionMatch match = here.match(line);
    if (const QString name = named.match(message).captured(1); !name.isEmpty())
        match =
            QRegularExpression(QStringLiteral("\\b%1\\s*=\\s*circles\\s*\\[([^\\]]+)\\]").arg(name))
                .match(source);
    const auto value = match.hasMatch() ? valueOf(host, match.captured(1)) : std::nullopt;
    const auto count = static_cast<double>(host.circles.size());
    if (!value || (*value >= 1.0 && *value <= count))
        return {};
    return MeantText::tr(". There is no circles[%1]: circles are counted from 1 to %2")
        .arg(*value)
        .arg(host.circles.size());
}

/// A parameter that holds nothing is most often a call that gave nothing for it.
QString missingArgument(const ScriptHost &host, const QString &message, const QString &source)
{
    static const QRegularExpression named(QStringLiteral("\\bnil value \\(local '(\\w+)'\\)"));
    const QString name = named.match(message).captured(1);
    const QRegularExpression assigned(QStringLiteral("\\b%1\\s*(,[^=\\n]*)?=(?!=)").arg(name));
    if (host.calledFrom == 0 || !host.missing.contains(name) || source.contains(assigned))
        return {};
    return MeantText::tr(". Look at what the call in line %1 gives for it").arg(host.calledFrom);
}

/// math.sqrt for Math.Sqrt.
QString meantByMath(const QString &member)
{
    static const std::map<QString, QString> others{
        {QStringLiteral("PI"), QStringLiteral("math.pi")},
        {QStringLiteral("Pow"), QStringLiteral("a ^ b")},
        {QStringLiteral("Atan2"), QStringLiteral("math.atan(y, x)")},
        {QStringLiteral("Ceiling"), QStringLiteral("math.ceil")},
        {QStringLiteral("Round"), QStringLiteral("math.floor(x + 0.5)")},
        {QStringLiteral("Clamp"), QStringLiteral("math.max(low, math.min(x, high))")},
        {QStringLiteral("Sign"), QStringLiteral("x > 0 and 1 or -1")}};
    const auto known = others.find(member);
    return known != others.end() ? known->second : QStringLiteral("math.") + member.toLower();
}

} // namespace

QString meantAtRunTime(lua_State *L, const QString &message, int line, const QString &source)
{
    const QString code = lineOf(source, line);
    static const QRegularExpression length(QStringLiteral("\\b(\\w+)\\.(Length|Count|length)\\b"));
    const bool isNil = message.contains(QLatin1String("nil"));
    if (isNil || message.contains(QLatin1String("'for' limit"))) {
        if (const auto match = length.match(code); match.hasMatch())
            return MeantText::tr(". The length of a list is #%1").arg(match.captured(1));
    }
    if (const QString missing = missingArgument(ScriptHost::of(L), message, source);
        !missing.isEmpty())
        return missing;
    if (isNil && message.startsWith(QLatin1String("attempt to index")))
        return noSuchCircle(ScriptHost::of(L), message, code, source);
    if (message.startsWith(QLatin1String("attempt to add "))
        && message.contains(QLatin1String("'string'")))
        return MeantText::tr(". Texts are joined by .., not by +");
    if (message.contains(QLatin1String("a function value (field '")))
        return MeantText::tr(
            ". A function is called with its parentheses, and that of a vector with a "
            "colon: v:length()");
    return {};
}

QString meantByName(lua_State *L, const QString &name)
{
    const QString code = lineOf(ScriptHost::of(L).source, currentLine(L));
    static const QRegularExpression math(QStringLiteral("\\bMath[fF]?\\.(\\w+)"));
    if (const auto match = math.match(code);
        name.startsWith(QLatin1String("Math")) && match.hasMatch())
        return MeantText::tr("`%1.%2` is %3 in Lua")
            .arg(name, match.captured(1), meantByMath(match.captured(1)));
    if (name == QLatin1String("null"))
        return MeantText::tr("Lua has no null; nothing is written nil");
    if (name == QLatin1String("this") || name == QLatin1String("self"))
        return MeantText::tr(
                   "there is no `%1` here; the circles are circle1, circle2 …, and what is "
                   "your own has its plain name")
            .arg(name);
    if (name == QLatin1String("new"))
        return MeantText::tr("Lua has no `new`; a vector is made by vec(x, y), a table by {}");
    static const QRegularExpression vector(
        QStringLiteral("^(Vector|Vec)\\d?$|^Point$|^vector\\d?$"));
    if (name.contains(vector))
        return MeantText::tr("`%1` is not known; a vector is made by vec(x, y)").arg(name);
    static const QRegularExpression step(
        QStringLiteral("^(dt|d_t|Time|timestep|time_?step|delta(_?time)?)$"),
        QRegularExpression::CaseInsensitiveOption);
    if (name != QLatin1String("time") && name.contains(step))
        return MeantText::tr("`%1` is not known here; how long a step lasts is the parameter of "
                             "on_update, which other functions get as an argument")
            .arg(name);
    if (name == QLatin1String("Console") || name == QLatin1String("Debug"))
        return MeantText::tr("`%1` is not known; print(…) writes to the console").arg(name);
    if (code.contains(QRegularExpression(
            QStringLiteral("//.*\\b%1\\b").arg(QRegularExpression::escape(name)))))
        return MeantText::tr("`%1` is not known; // divides, a comment begins with -- in Lua")
            .arg(name);
    return {};
}

QString meantByLocals(lua_State *L, const QString &name, QStringList &visible)
{
    ScriptHost &host = ScriptHost::of(L);
    host.instructions += host.source.size() / lettersPerInstruction;
    const int line = currentLine(L);
    QString elsewhere;
    for (const LocalName &local : localNames(host.source)) {
        if (local.line <= line && local.lastLine >= line)
            visible.append(local.name);
        if (local.name != name)
            continue;
        if (local.isOutermost && local.line > line)
            return MeantText::tr(
                       "`%1` is not known yet: it is local and stands below, in line %2; move "
                       "it up, or leave out `local`")
                .arg(name)
                .arg(local.line);
        if (local.lastLine >= line && local.line <= line)
            continue;
        elsewhere =
            isInCurrentFunction(L, local.line)
                ? MeantText::tr("`%1` is not known here: it is local to the block of line "
                                "%2; declare it before that block")
                : MeantText::tr(
                    "`%1` is not known here: it is local to another block, in "
                    "line %2; a function gets what it needs as an argument, or makes it itself");
        elsewhere = elsewhere.arg(name).arg(local.line);
    }
    return elsewhere;
}

} // namespace cradle
