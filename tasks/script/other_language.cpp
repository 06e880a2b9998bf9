// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/other_language.h"

#include "tasks/script/kept_pattern.h"

#include "tasks/script/lua_tokens.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace cradle {

namespace {

struct GrammarText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Something of another language: what it looks like, and the words, with what was captured.
struct Habit {
    const char *pattern;
    const char *words;
};

#define TYPE                                                                                       \
    "(?:void|float|double|int|uint|long|bool|string|var|let|auto|object|char|byte|decimal|"        \
    "Vector\\d|[A-Z]\\w*)(?:\\[\\]|<[^<>]*>)?"
#define BRACE "(?:\\)\\s*\\{|\\{\\s*$)"
#define MODIFIERS "(?:(?:public|private|protected|internal|static|const|readonly|override)\\s+)*"

// clang-format off
constexpr Habit habits[] = {
    {"\\bforeach\\s*\\(\\s*(?:\\w+\\s+)?(\\w+)\\s+in\\s+([\\w.]+)", QT_TRANSLATE_NOOP("Script", "Lua has no foreach; write: for _, %1 in ipairs(%2) do … end")},
    {"\\bfor\\s*(?:\\(\\s*(?:\\w+\\s+)?(\\w+)\\s*=|(\\w+)\\s*=[^;]*;)", QT_TRANSLATE_NOOP("Script", "a loop that counts is written: for %1 = first, last do … end, both included")},
    {"=>", QT_TRANSLATE_NOOP("Script", "Lua has no =>; a function is function(x) return … end, and \"greater or equal\" is >=")},
    {"\\?.*:", QT_TRANSLATE_NOOP("Script", "Lua has no ? : to choose; write: if … then … else … end, or: condition and a or b")},
    {"([\\w.]+)\\s*([-+*/])=\\s*(.*[^\\s;])", QT_TRANSLATE_NOOP("Script", "Lua has no %2=; write %1 = %1 %2 %3")},
    {"!=", QT_TRANSLATE_NOOP("Script", "\"not equal\" is ~= in Lua, not !=")},
    {"([\\w.]+)\\+\\+|\\+\\+([\\w.]+)", QT_TRANSLATE_NOOP("Script", "Lua has no ++; write %1 = %1 + 1")},
    {"&&|\\|\\|", QT_TRANSLATE_NOOP("Script", "Lua writes `and`, `or`, `not` in words")},
    {"!\\s*[\\w(]", QT_TRANSLATE_NOOP("Script", "Lua writes `not` in words, not !")},
    {"^\\s*" MODIFIERS TYPE "\\s+(\\w+)\\s*\\(", QT_TRANSLATE_NOOP("Script", "Lua names no types; a function is written: function %1(…) … end")},
    {"^\\s*(?:local\\s+)?" MODIFIERS TYPE "\\s+(\\w+)\\s*(?:[=;,]|$)", QT_TRANSLATE_NOOP("Script", "Lua names no types; write: local %1 = …")},
    {"^\\s*const\\s+(\\w+)\\s*=", QT_TRANSLATE_NOOP("Script", "Lua names no types; write: local %1 = …")},
    {"\\bfunction\\b[^(]*\\([^)]*\\b" TYPE "\\s+(\\w+)", QT_TRANSLATE_NOOP("Script", "Lua names no types; of a parameter write only the name: %1")},
    {"^\\s*(using|class|struct|namespace|public|private|static|import|switch|try|catch|throw)\\b", QT_TRANSLATE_NOOP("Script", "Lua has no `%1`")},
    {"^\\s*continue\\b", QT_TRANSLATE_NOOP("Script", "Lua has no `continue`; put what it leaves out into an if")},
    {"^\\s*//|[;)]\\s*//|//\\s*\\w+\\s+\\w|/\\*|^\\s*#", QT_TRANSLATE_NOOP("Script", "a comment begins with -- in Lua")},
    {"\\b(?:if|elseif)\\b.*" BRACE "|\\belse\\s*\\{|\\}\\s*else\\b", QT_TRANSLATE_NOOP("Script", "Lua has no braces around blocks; write: if … then … else … end")},
    {"\\bwhile\\b.*" BRACE, QT_TRANSLATE_NOOP("Script", "Lua has no braces around blocks; write: while … do … end")},
    {"\\bfor\\b.*" BRACE, QT_TRANSLATE_NOOP("Script", "Lua has no braces around blocks; write: for … do … end")},
    {"\\bfunction\\b.*" BRACE, QT_TRANSLATE_NOOP("Script", "Lua has no braces around blocks; write: function name(…) … end")},
    {"^\\s*[{}]\\s*$", QT_TRANSLATE_NOOP("Script", "Lua has no braces around blocks; a block ends with `end`")},
    {"\\b(?:if|while|elseif)\\b(?:[^=<>~]*[^=<>~]|.*\\b(?:and|or)\\s+(?:not\\s+)?[\\w.]+\\s*)=[^=]", QT_TRANSLATE_NOOP("Script", "= assigns; to compare write ==")},
    {"^\\s*[\\w.]+\\s*==\\s*", QT_TRANSLATE_NOOP("Script", "== compares; to assign write =")},
    {"([\\x{2010}-\\x{2015}\\x{2212}])", QT_TRANSLATE_NOOP("Script", "%1 is not the minus of Lua; write -")},
    {"(?=[^\\x00-\\x7F])\\p{L}", QT_TRANSLATE_NOOP("Script", "names have the letters a to z, digits and _ only")},
    {"([^\\x00-\\x7F])", QT_TRANSLATE_NOOP("Script", "Lua does not know the sign %1")},
};
// clang-format on

/// The program's lines without what is in texts and comments.
QStringList codeLines(const QString &source)
{
    QByteArray text = source.toUtf8();
    const QByteArray whole = text;
    for (const LuaToken &token : luaTokens(whole)) {
        const bool comment = token.kind == LuaToken::Kind::Comment;
        if (!comment && token.kind != LuaToken::Kind::String)
            continue;
        // The signs around a text stay: "" is a text without letters.
        for (qsizetype i = token.start + (comment ? 0 : 1); i < token.end() - (comment ? 0 : 1);
             ++i) {
            if (text[i] != '\n')
                text[i] = ' ';
        }
    }
    return QString::fromUtf8(text).split(QLatin1Char('\n'));
}

/// The words of the first habit in \p code; \p raw is the same line with its comment.
QString habitIn(const QString &code, const QString &raw)
{
    for (const Habit &habit : habits) {
        // What follows // is prose.
        const bool whole = QByteArrayView(habit.pattern).contains("//");
        const QString part = whole ? code : code.section(QStringLiteral("//"), 0, 0);
        const QRegularExpressionMatch match = keptPattern(QLatin1String(habit.pattern)).match(part);
        if (!match.hasMatch())
            continue;
        QStringList captured;
        for (int i = 1; i <= match.lastCapturedIndex(); ++i) {
            if (!match.captured(i).isNull() && !match.captured(i).isEmpty())
                captured.append(match.captured(i));
        }
        QString words = GrammarText::tr(habit.words);
        for (int i = 0; i < captured.size(); ++i)
            words.replace(QStringLiteral("%%1").arg(i + 1), captured[i]);
        return words;
    }
    // To Lua that is a comment.
    static const QRegularExpression decrement(QStringLiteral("^\\s*([\\w.]+)--\\s*;?\\s*$"));
    if (const auto match = decrement.match(raw); match.hasMatch())
        return GrammarText::tr("Lua has no --, which begins a comment; write %1 = %1 - 1")
            .arg(match.captured(1));
    return {};
}

/// The lines of a program around an error.
class Place
{
public:
    Place(const QString &source, int line)
        : m_raw(source.split(QLatin1Char('\n')))
        , m_code(codeLines(source))
        , m_line(line)
    {
    }

    [[nodiscard]] QString code(int line) const { return m_code.value(line - 1); }
    [[nodiscard]] QString habit(int line) const
    {
        return habitIn(code(line), m_raw.value(line - 1));
    }
    /// The last line before that has more than a comment; 0 without one.
    [[nodiscard]] int before() const
    {
        int line = m_line - 1;
        while (line > 0 && code(line).trimmed().isEmpty())
            --line;
        return line;
    }
    /// Whether the parser stopped at the first word of the line, so that the one before may be at
    /// fault.
    [[nodiscard]] bool isAtStart(const QString &message) const
    {
        static const QRegularExpression near(QStringLiteral("near '?(.+?)'?$"));
        const QString word = near.match(message).captured(1);
        return word == QLatin1String("<eof>") || code(m_line).trimmed().startsWith(word);
    }
    /// The first line up to the error where a block is opened by a brace, with the words for it.
    /// Lua may take a condition and a brace for a call, f {…}, and go on until the end.
    [[nodiscard]] GrammarHint brace() const
    {
        static const QRegularExpression block(
            QStringLiteral("^\\s*\\}?\\s*(?:if|elseif|else|while|for|function|local\\s+function)"
                           "\\b(?!.*\\b(?:then|do|"
                           "return)\\b)"));
        static const QRegularExpression open(QStringLiteral("\\{\\s*$"));
        QString head;
        for (int line = 1; line <= m_line; ++line) {
            const QString now = code(line);
            if (now.contains(block) && now.contains(open))
                return {habit(line), line};
            if (now.trimmed() == QLatin1String("{") && head.contains(block))
                return {habitIn(head + now, {}), line};
            if (!now.trimmed().isEmpty())
                head = now;
        }
        return {};
    }
    /// The first line that has "else if", which Lua takes for two; 0 without one.
    [[nodiscard]] int elseIf() const
    {
        static const QRegularExpression pattern(QStringLiteral("\\belse[ \\t]+if\\b"));
        for (int line = 1; line <= m_code.size(); ++line) {
            if (code(line).contains(pattern))
                return line;
        }
        return 0;
    }

private:
    QStringList m_raw;
    QStringList m_code;
    int m_line;
};

} // namespace

GrammarHint otherLanguage(const QString &source, int line, const QString &message)
{
    const Place place(source, line);
    if (const GrammarHint hint = place.brace(); !hint.text.isEmpty())
        return hint;
    if (const QString words = place.habit(line); !words.isEmpty())
        return {words, line};
    const bool atStart = place.isAtStart(message);
    const int before = atStart ? place.before() : line;
    static const QRegularExpression leaves(QStringLiteral("\\breturn\\b"));
    static const QRegularExpression leavesBefore(QStringLiteral("\\breturn\\s*;?\\s*$"));
    const bool endWanted = message.startsWith(QLatin1String("'end' expected"))
                           || message.startsWith(QLatin1String("'<eof>' expected"));
    if (endWanted && !message.endsWith(QLatin1String("<eof>"))

        && (place.code(before).contains(leaves)
            || place.code(place.before()).contains(leavesBefore)))
        return {
            GrammarText::tr("return ends its block: nothing may follow it there but end, else or "
                            "elseif"),
            line};
    if (before > 0 && before < line) {
        if (const QString words = place.habit(before); !words.isEmpty())
            return {words, before};
        for (const char *word : {"then", "do"}) {
            if (message.startsWith(QStringLiteral("'%1' expected").arg(QLatin1String(word))))
                return {GrammarText::tr("here `%1` is missing").arg(QLatin1String(word)), before};
        }
    }
    if (endWanted && place.elseIf() > 0)
        return {GrammarText::tr("an `end` is missing: `else if` begins a second if, which needs an "
                                "`end` of its own; the one word elseif does not"),
                place.elseIf()};
    return {};
}

} // namespace cradle
