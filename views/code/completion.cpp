// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/completion.h"

#include "tasks/script/lua_tokens.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

using Kind = LuaToken::Kind;

/// The name under which the members of \p owner are listed; empty if they are not known.
QString membersOf(const QString &owner, QChar link)
{
    static const QRegularExpression circle(QStringLiteral("^circle[0-9]+$"));
    static const QStringList libraries{QStringLiteral("square"), QStringLiteral("draw"),
                                       QStringLiteral("math"), QStringLiteral("string"),
                                       QStringLiteral("table")};
    if (link == u':')
        return QStringLiteral("vec");
    if (circle.match(owner).hasMatch() || owner == QLatin1String("circles[]"))
        return QStringLiteral("circle");
    if (owner == QLatin1String("position") || owner == QLatin1String("velocity")
        || owner == QLatin1String("gravity"))
        return QStringLiteral("xy");
    return libraries.contains(owner) ? owner : QString();
}

bool isSign(const LuaToken &token, QByteArrayView text, char sign)
{
    return token.kind == Kind::Sign && token.in(text) == QByteArrayView(&sign, 1);
}

QString nameOf(const LuaToken &token, QByteArrayView text)
{
    return QString::fromUtf8(token.in(text));
}

/// The owner of a member whose "." or ":" is tokens[at].
QString ownerBefore(const std::vector<LuaToken> &tokens, std::size_t at, QByteArrayView text)
{
    if (at == 0)
        return {};
    const LuaToken &last = tokens[at - 1];
    if (last.kind == Kind::Name)
        return nameOf(last, text);
    if (!isSign(last, text, ']'))
        return {};
    std::size_t open = at - 1;
    while (open > 0 && !isSign(tokens[open], text, '['))
        --open;
    const bool named = open > 0 && tokens[open - 1].kind == Kind::Name;
    return named ? nameOf(tokens[open - 1], text) + QStringLiteral("[]") : QString();
}

/// The names in \p program but for the one that ends at \p cursor and is still being typed.
QStringList namesIn(QByteArrayView program)
{
    QStringList names;
    for (const LuaToken &token : luaTokens(program)) {
        if (token.kind == Kind::Name && token.length > 2)
            names.append(nameOf(token, program));
    }
    names.sort(Qt::CaseInsensitive);
    return names;
}

bool fits(const CompletionPlace &place, const ApiWord &word)
{
    if (!word.name.startsWith(place.begun, Qt::CaseInsensitive))
        return false;
    if (place.link.isNull())
        return word.owner.isEmpty();
    if (place.known)
        return word.owner == membersOf(place.owner, place.link);
    return word.owner == QLatin1String("circle") || word.owner == QLatin1String("xy");
}

/// A function of the program itself, with the parameters that it is defined with.
std::optional<ApiWord> ownFunction(const QString &name, const QString &program)
{
    const QRegularExpression definition(
        QStringLiteral("\\bfunction\\s+%1\\s*\\(([^)]*)\\)|\\b%1\\s*=\\s*function\\s*\\(([^)]*)\\)")
            .arg(QRegularExpression::escape(name)));
    const QRegularExpressionMatch match = definition.match(program);
    if (!match.hasMatch())
        return std::nullopt;
    ApiWord word;
    word.name = name;
    word.signature =
        QStringLiteral("%1(%2)").arg(name, (match.captured(1) + match.captured(2)).simplified());
    word.kind = ApiWord::Kind::Own;
    return word;
}

std::optional<ApiWord> functionCalled(const QString &owner, QChar link, const QString &name)
{
    const QString members = link.isNull() ? QString() : membersOf(owner, link);
    for (const ApiWord &word : apiWords()) {
        if (word.name == name && word.owner == members && word.signature.contains(u'('))
            return word;
    }
    return std::nullopt;
}

} // namespace

std::optional<CompletionPlace> completionPlace(QByteArrayView before)
{
    const std::vector<LuaToken> tokens = luaTokens(before);
    CompletionPlace place;
    if (tokens.empty() || tokens.back().end() != before.size())
        return place;
    std::size_t at = tokens.size() - 1;
    if (tokens[at].open || tokens[at].kind == Kind::Number || tokens[at].kind == Kind::Comment
        || tokens[at].kind == Kind::String)
        return std::nullopt;
    const bool word = tokens[at].kind != Kind::Sign;
    if (word) {
        place.begun = nameOf(tokens[at], before);
        if (at == 0 || tokens[at - 1].end() != tokens[at].start)
            return place;
        --at;
    }
    const bool dot = isSign(tokens[at], before, '.');
    const bool colon = isSign(tokens[at], before, ':');
    if (!dot && !colon)
        return place;
    place.link = dot ? u'.' : u':';
    place.owner = ownerBefore(tokens, at, before);
    place.known = colon || !membersOf(place.owner, place.link).isEmpty();
    return place;
}

std::vector<ApiWord> completions(const CompletionPlace &place, QByteArrayView program)
{
    std::vector<ApiWord> words;
    for (const ApiWord &word : apiWords()) {
        if (fits(place, word))
            words.push_back(word);
    }
    std::ranges::stable_sort(
        words, {}, [](const ApiWord &word) { return word.kind == ApiWord::Kind::Keyword ? 1 : 0; });
    // What is there as a whole comes first: nobody wants another then.
    std::stable_partition(words.begin(), words.end(),
                          [&](const ApiWord &word) { return word.name == place.begun; });
    if (place.known)
        return words;
    const QStringList names = namesIn(program);
    const auto count = names.count(place.begun);
    for (const QString &name : names) {
        const bool typed = name == place.begun && count < 2;
        const auto same = [&name](const ApiWord &word) { return word.name == name; };
        if (typed || !name.startsWith(place.begun, Qt::CaseInsensitive)
            || std::ranges::any_of(words, same))
            continue;
        ApiWord own;
        own.name = name;
        own.kind = ApiWord::Kind::Own;
        words.push_back(own);
    }
    return words;
}

std::optional<CallPlace> callPlace(QByteArrayView before, QByteArrayView after)
{
    const std::vector<LuaToken> tokens = luaTokens(before);
    if (!tokens.empty() && tokens.back().open && tokens.back().kind == Kind::Comment)
        return std::nullopt;
    CallPlace place;
    int depth = 0;
    std::size_t at = tokens.size();
    while (at > 0) {
        --at;
        const LuaToken &token = tokens[at];
        // No call spans a statement, but for functions among its arguments.
        const QByteArrayView word = token.in(before);
        if (token.kind == Kind::Keyword && word != "not" && word != "and" && word != "or")
            return std::nullopt;
        if (token.kind != Kind::Sign)
            continue;
        const char sign = word[0];
        if (sign == ')' || sign == '}' || sign == ']')
            ++depth;
        else if (sign == ',' && depth == 0)
            ++place.argument;
        else if ((sign == '(' || sign == '{' || sign == '[') && --depth < 0)
            break;
    }
    if (depth >= 0 || at == 0 || !isSign(tokens[at], before, '(')
        || tokens[at - 1].kind != Kind::Name)
        return std::nullopt;
    const bool defined = at > 1 && nameOf(tokens[at - 2], before) == QLatin1String("function");
    if (defined)
        return std::nullopt;
    const QString name = nameOf(tokens[at - 1], before);
    QString owner;
    QChar link;
    if (at > 1 && (isSign(tokens[at - 2], before, '.') || isSign(tokens[at - 2], before, ':'))) {
        link = QLatin1Char(tokens[at - 2].in(before)[0]);
        owner = ownerBefore(tokens, at - 2, before);
    }
    std::optional<ApiWord> function;
    if (link.isNull())
        function = ownFunction(name, QString::fromUtf8(before) + QString::fromUtf8(after));
    if (!function)
        function = functionCalled(owner, link, name);
    if (!function)
        return std::nullopt;
    place.function = *function;
    return place;
}

} // namespace cradle
