// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <QHash>

#include <algorithm>

namespace cradle {

namespace {

/// circle2 for circle1, b for a, y for x.
void exchangeName(RepairList &repairs, std::size_t i)
{
    const ProgramToken &name = repairs.tokens()[i];
    if (name.kind != ProgramToken::Kind::Name || repairs.program().isNewName(i))
        return;
    static const QList<std::pair<QChar, QChar>> ends{{QLatin1Char('a'), QLatin1Char('b')},
                                                     {QLatin1Char('1'), QLatin1Char('2')},
                                                     {QLatin1Char('x'), QLatin1Char('y')}};
    for (const auto &[one, two] : ends) {
        for (const auto &[from, to] : {std::pair(one, two), std::pair(two, one)}) {
            for (const qsizetype at : {qsizetype{0}, name.text.size() - 1}) {
                QString partner = name.text;
                if (partner[at] != from)
                    continue;
                partner[at] = to;
                if (repairs.program().hasName(partner))
                    repairs.replace(name, partner);
            }
        }
    }
    if (const QString other = repairs.partnerOf(name.text); !other.isEmpty())
        repairs.replace(name, other);
    static const QHash<QString, QString> pairs{{QStringLiteral("right"), QStringLiteral("left")},
                                               {QStringLiteral("left"), QStringLiteral("right")},
                                               {QStringLiteral("top"), QStringLiteral("bottom")},
                                               {QStringLiteral("bottom"), QStringLiteral("top")},
                                               {QStringLiteral("up"), QStringLiteral("down")},
                                               {QStringLiteral("down"), QStringLiteral("up")},
                                               {QStringLiteral("high"), QStringLiteral("low")},
                                               {QStringLiteral("low"), QStringLiteral("high")},
                                               {QStringLiteral("max"), QStringLiteral("min")},
                                               {QStringLiteral("min"), QStringLiteral("max")},
                                               {QStringLiteral("sin"), QStringLiteral("cos")},
                                               {QStringLiteral("cos"), QStringLiteral("sin")},
                                               {QStringLiteral("one"), QStringLiteral("other")},
                                               {QStringLiteral("other"), QStringLiteral("one")}};
    const QString partner = pairs.value(name.text);
    if (!partner.isEmpty())
        repairs.replace(name, partner);
    if (name.text == QLatin1String("restitution")) {
        repairs.replace(name, QStringLiteral("1"));
        repairs.replace(name, QStringLiteral("(1 + restitution)"));
    }
}

/// What belongs to one circle, taken from another that is named nearby.
void exchangeOwner(RepairList &repairs, std::size_t i)
{
    const ProgramToken &name = repairs.tokens()[i];
    const bool isOwner = name.kind == ProgramToken::Kind::Name && repairs.is(i + 1, ".")
                         && !(repairs.is(i - 1, ".") || repairs.is(i - 1, ":"));
    if (!isOwner)
        return;
    if (repairs.is(i + 2, "radius") || repairs.is(i + 2, "mass") || repairs.is(i + 2, "density")) {
        for (const QString &body : repairs.program().bodiesNear(name.line))
            repairs.replace(name, body);
    }
    const ProgramFunction *function = functionAt(repairs.functions(), name.line);
    QStringList owners = function ? function->parameters : QStringList{};
    owners.append(QStringLiteral("self"));
    if (!owners.contains(name.text) || !function)
        return;
    for (const QString &other : owners) {
        if (repairs.program().isOwner(other))
            repairs.replace(name, other);
    }
}

/// A place in a list that another index names.
void exchangeIndex(RepairList &repairs, std::size_t i)
{
    const ProgramToken &name = repairs.tokens()[i];
    const auto isIndex = [&](std::size_t at) {
        return repairs.tokens()[at].kind == ProgramToken::Kind::Name && repairs.is(at - 1, "[")
               && repairs.is(at + 1, "]");
    };
    const ProgramFunction *function = functionAt(repairs.functions(), name.line);
    if (!function || !isIndex(i))
        return;
    for (int line = function->first; line <= function->last; ++line) {
        for (const std::size_t at : repairs.program().tokensOf(line)) {
            if (isIndex(at))
                repairs.replace(name, repairs.tokens()[at].text);
        }
    }
}

/// Another function that takes as much, called or handed on; the other truth; the other of two
/// texts.
void exchangeChoice(RepairList &repairs, std::size_t i)
{
    const ProgramToken &token = repairs.tokens()[i];
    if (token.is("true") || token.is("false"))
        repairs.replace(token, token.is("true") ? QStringLiteral("false") : QStringLiteral("true"));
    const auto &functions = repairs.functions();
    const auto named = [&](const QString &name) {
        return std::find_if(functions.begin(), functions.end(),
                            [&](const ProgramFunction &each) { return each.name == name; });
    };
    const bool isText = token.kind == ProgramToken::Kind::Text;
    const QString name = isText ? token.text.mid(1, token.text.size() - 2) : token.text;
    const auto own = named(name);
    const bool isHandedOn = repairs.is(i - 1, "{") || repairs.is(i - 1, ",")
                            || repairs.is(i - 1, "(") || repairs.is(i - 1, "=");
    if (own == functions.end() || name.isEmpty()
        || !(isText || isHandedOn || repairs.is(i + 1, "(")) || repairs.is(i - 1, "function"))
        return;
    for (const ProgramFunction &other : functions) {
        const bool isLike = other.parameters.size() == own->parameters.size() && other.name != name
                            && !other.name.isEmpty();
        if (isLike)
            repairs.replace(token.line, token.start + (isText ? 1 : 0),
                            token.end() - (isText ? 1 : 0), other.name);
    }
}

} // namespace

void repairNames(RepairList &repairs, std::size_t i)
{
    exchangeName(repairs, i);
    exchangeOwner(repairs, i);
    exchangeIndex(repairs, i);
    exchangeChoice(repairs, i);
}

} // namespace cradle
