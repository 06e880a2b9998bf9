// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <QHash>
#include <QSet>
#include <QStringList>

#include <algorithm>

namespace cradle {

namespace {

void changeNumber(RepairList &repairs, std::size_t i)
{
    const ProgramToken &number = repairs.tokens()[i];
    if (number.kind != ProgramToken::Kind::Number)
        return;
    QStringList others{QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("0.5"),
                       QStringLiteral("restitution")};
    if (number.text == QLatin1String("2"))
        others.append(QStringLiteral("(1 + restitution)"));
    if (i > 0 && repairs.tokens()[i - 1].is("^"))
        others = {QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3")};
    const bool isIndex = i > 0 && repairs.is(i - 1, "[") && repairs.is(i + 1, "]");
    if (isIndex)
        others = {QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("i")};
    for (const QString &other : others)
        repairs.replace(number, other);
    if (isIndex)
        return;
    if (number.text.size() < 4) {
        for (const QString &body : repairs.program().bodiesNear(number.line))
            repairs.replace(number, body + QStringLiteral(".radius"));
    }
    // 2 e or 2 - e for 1 + e
    if (number.text == QLatin1String("2") && (repairs.is(i + 1, "*") || repairs.is(i + 1, "-"))
        && repairs.is(i + 2, "restitution"))
        repairs.replace(number.line, number.start, repairs.tokens()[i + 1].end(),
                        QStringLiteral("1 +"));
    // 1 / 60
    const std::size_t last = repairs.is(i + 1, "/") && i + 2 < repairs.tokens().size() ? i + 2 : i;
    for (const QString &timestep : repairs.program().timesteps())
        repairs.replace(number.line, number.start, repairs.tokens()[last].end(), timestep);
    if (number.text.startsWith(QLatin1String("9.8")) && i > 0 && repairs.tokens()[i - 1].is("-"))
        repairs.replace(number.line, repairs.tokens()[i - 1].start, number.end(),
                        QStringLiteral("gravity.y"));
}

/// What has no sign: a circle or all of them, not what they have.
bool isWholeCircle(const RepairList &repairs, std::size_t i)
{
    const ProgramToken &name = repairs.tokens()[i];
    return !repairs.is(i + 1, ".") && !repairs.is(i + 1, "[")
           && (name.text == QLatin1String("circles")
               || repairs.program().bodiesNear(name.line).contains(name.text));
}

void changeSign(RepairList &repairs, std::size_t i)
{
    static const QList<std::pair<const char *, const char *>> pairs{
        {"+", "-"}, {"-", "+"}, {"*", "/"},   {"/", "*"},  {"*", "+"},
        {"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}};
    const ProgramToken &sign = repairs.tokens()[i];
    const bool binary = i > 0 && repairs.tokens()[i - 1].endsOperand();
    for (const auto &[from, to] : pairs) {
        if (sign.is(from) && (binary || !sign.is("-")))
            repairs.replace(sign, QLatin1String(to));
    }
    if (sign.is("-") && !binary)
        repairs.replace(sign, {});
    // A minus in front of what is given to a velocity or a function, but not of a circle.
    const bool begins =
        repairs.is(i, "=") || repairs.is(i, "(") || repairs.is(i, ",") || repairs.is(i, "return");
    if (begins && i + 1 < repairs.tokens().size()
        && repairs.tokens()[i + 1].kind == ProgramToken::Kind::Name
        && !isWholeCircle(repairs, i + 1))
        repairs.insertAfter(sign, QStringLiteral(" -"));
}

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
    static const QHash<QString, QString> pairs{{QStringLiteral("right"), QStringLiteral("left")},
                                               {QStringLiteral("left"), QStringLiteral("right")},
                                               {QStringLiteral("top"), QStringLiteral("bottom")},
                                               {QStringLiteral("bottom"), QStringLiteral("top")},
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

/// A call of another function that takes as much; the other truth; the other of two texts.
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
    if (own == functions.end() || name.isEmpty() || !(isText || repairs.is(i + 1, "("))
        || (i > 0 && repairs.is(i - 1, "function")))
        return;
    for (const ProgramFunction &other : functions) {
        const bool isLike = other.parameters.size() == own->parameters.size() && other.name != name
                            && !other.name.isEmpty();
        if (isLike)
            repairs.replace(token.line, token.start + (isText ? 1 : 0),
                            token.end() - (isText ? 1 : 0), other.name);
    }
}

/// What belongs to one circle, taken from another that is named nearby.
void exchangeOwner(RepairList &repairs, std::size_t i)
{
    const ProgramToken &name = repairs.tokens()[i];
    if (name.kind != ProgramToken::Kind::Name || !repairs.is(i + 1, ".")
        || !(repairs.is(i + 2, "radius") || repairs.is(i + 2, "mass")
             || repairs.is(i + 2, "density")))
        return;
    for (const QString &body : repairs.program().bodiesNear(name.line))
        repairs.replace(name, body);
}

} // namespace

void repairWords(RepairList &repairs, std::size_t i)
{
    changeNumber(repairs, i);
    changeSign(repairs, i);
    exchangeName(repairs, i);
    exchangeOwner(repairs, i);
    exchangeChoice(repairs, i);
}

} // namespace cradle
