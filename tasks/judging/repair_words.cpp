// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <QSet>
#include <QStringList>

namespace cradle {

namespace {

/// Whether tokens \p from to \p to, without that, are all that is given, or one of a list.
bool isElement(const RepairList &repairs, std::size_t from, std::size_t to)
{
    const bool begins = repairs.is(from - 1, "=") || repairs.is(from - 1, ",")
                        || repairs.is(from - 1, "(") || repairs.is(from - 1, "{");
    return begins
           && (repairs.lineOf(to) != repairs.lineOf(to - 1) || repairs.is(to, ",")
               || repairs.is(to, ")") || repairs.is(to, "}"));
}

void changeNumber(RepairList &repairs, std::size_t i)
{
    const ProgramToken &number = repairs.tokens()[i];
    if (number.kind != ProgramToken::Kind::Number)
        return;
    QStringList others{QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("0.5"),
                       QStringLiteral("restitution")};
    if (number.text == QLatin1String("2"))
        others.append(QStringLiteral("(1 + restitution)"));
    if (repairs.is(i - 1, "^"))
        others = {QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3")};
    const bool isIndex = repairs.is(i - 1, "[") && repairs.is(i + 1, "]");
    const std::size_t before = repairs.is(i - 1, "-") ? i - 1 : i;
    if (isElement(repairs, before, i + 1)) {
        others.append(QStringLiteral("0"));
        if (before == i)
            others.append(QLatin1Char('-') + number.text);
    } else if (repairs.is(i - 1, "<") || repairs.is(i - 1, ">")) {
        others.append(QStringLiteral("0"));
    }
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
    // A wall as a number.
    if (number.text.toDouble() > 3.0 && number.text.toDouble() < 5.0)
        repairs.replace(number, QStringLiteral("square.half_width"));
    // 2 e or 2 - e for 1 + e
    if (number.text == QLatin1String("2") && (repairs.is(i + 1, "*") || repairs.is(i + 1, "-"))
        && repairs.is(i + 2, "restitution"))
        repairs.replace(number.line, number.start, repairs.tokens()[i + 1].end(),
                        QStringLiteral("1 +"));
    // 1 / 60
    const std::size_t last = repairs.is(i + 1, "/") && i + 2 < repairs.tokens().size() ? i + 2 : i;
    for (const QString &timestep : repairs.program().timesteps())
        repairs.replace(number.line, number.start, repairs.tokens()[last].end(), timestep);
    if (number.text.startsWith(QLatin1String("9.8")) && repairs.is(i - 1, "-"))
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
    const bool binary = repairs.endsOperand(i - 1);
    for (const auto &[from, to] : pairs) {
        if (sign.is(from) && (binary || !sign.is("-")))
            repairs.replace(sign, QLatin1String(to));
    }
    if (sign.is("-") && !binary)
        repairs.replace(sign, {});
    // A minus in front of what is given to a velocity or a function, but not of a circle.
    const bool begins = repairs.is(i, "=") || repairs.is(i, "(") || repairs.is(i, ",")
                        || repairs.is(i, "return") || repairs.is(i, "and") || repairs.is(i, "or");
    if (begins && i + 1 < repairs.tokens().size()
        && repairs.tokens()[i + 1].kind == ProgramToken::Kind::Name
        && !isWholeCircle(repairs, i + 1))
        repairs.insertAfter(sign, QStringLiteral(" -"));
}

} // namespace

void repairWords(RepairList &repairs, std::size_t i)
{
    changeNumber(repairs, i);
    changeSign(repairs, i);
}

} // namespace cradle
