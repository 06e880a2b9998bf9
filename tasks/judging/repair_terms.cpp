// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

namespace cradle {

namespace {

/// A factor or a term too many.
void dropOperand(RepairList &repairs, std::size_t i)
{
    const ProgramToken &sign = repairs.tokens()[i];
    const bool joins = sign.is("*") || sign.is("/") || sign.is("^") || sign.is("+")
                       || (sign.is("-") && repairs.endsOperand(i - 1));
    if (joins) {
        const std::size_t after = repairs.program().afterOperand(i + 1);
        if (after > i + 1)
            repairs.replace(sign.line, sign.start, repairs.tokens()[after - 1].end(), {});
    }
    const std::size_t after = repairs.program().afterOperand(i);
    if (after > i && after + 1 < repairs.tokens().size() && (repairs.tokens()[after].is("*"))
        && !(repairs.is(i - 1, ".") || repairs.is(i - 1, ":")))
        repairs.replace(sign.line, sign.start, repairs.tokens()[after + 1].start, {});
}

/// A factor that is missing behind an operand.
void addFactor(RepairList &repairs, std::size_t i)
{
    const ProgramToken &token = repairs.tokens()[i];
    if (repairs.is(i - 1, ".") || repairs.is(i - 1, ":"))
        return;
    const std::size_t after = repairs.program().afterOperand(i);
    if (after == i || repairs.program().isCall(token.line) || repairs.is(after, "=")
        || repairs.is(after, ",") || repairs.tokens()[after - 1].line != token.line)
        return;
    const ProgramToken &last = repairs.tokens()[after - 1];
    const bool isRate = last.is("velocity") || last.is("gravity") || last.is(")") || last.is("x")
                        || last.is("y") || last.text.startsWith(u'v') || last.text.startsWith(u'g');
    if (isRate) {
        for (const QString &timestep : repairs.program().timesteps())
            repairs.insertAfter(last, QStringLiteral(" * ") + timestep);
    }
    // Something that is turned round.
    const bool isTurned = repairs.is(i - 1, "-") && !repairs.endsOperand(i - 2);
    if (isRate || isTurned)
        repairs.insertAfter(last, QStringLiteral(" * restitution"));
    if (last.is("radius") && after >= 3
        && repairs.tokens()[after - 3].kind == ProgramToken::Kind::Name) {
        const QString body = repairs.tokens()[after - 3].text;
        for (const QString &other : repairs.program().bodiesNear(token.line)) {
            if (other != body && repairs.is(i - 1, "="))
                repairs.insertAfter(last, QStringLiteral(" + %1.radius").arg(other));
        }
        repairs.insertAfter(last, QStringLiteral(" * %1.radius").arg(body));
        repairs.insertAfter(last, QStringLiteral(" * %1.density").arg(body));
    }
    const bool isCompared = (repairs.is(i - 1, "<") || repairs.is(i - 1, ">")
                             || repairs.is(i - 1, "<=") || repairs.is(i - 1, ">="));
    if (last.kind == ProgramToken::Kind::Number || last.is("radius") || isCompared)
        repairs.insertAfter(last, QStringLiteral(" ^ 2"));
}

/// Whether a name only ever gets whole numbers, or one more or less than it has.
bool isCount(const RepairList &repairs, const QString &name)
{
    bool isGiven = false;
    for (const ProgramAssignment &each : repairs.assignments()) {
        if (each.name != name)
            continue;
        isGiven = true;
        for (std::size_t at = each.from; at < each.to; ++at) {
            const ProgramToken &token = repairs.tokens()[at];
            const bool isWhole =
                token.kind == ProgramToken::Kind::Number && !token.text.contains(QLatin1Char('.'));
            if (!isWhole && token.text != name && !token.is("+") && !token.is("-"))
                return false;
        }
    }
    return isGiven;
}

/// The rim for the centre, on either side of a comparison.
void addRadius(RepairList &repairs, std::size_t i)
{
    const ProgramToken &sign = repairs.tokens()[i];
    if (!(sign.is("<") || sign.is(">") || sign.is("<=") || sign.is(">=")) || i == 0
        || isCount(repairs, repairs.tokens()[i - 1].text))
        return;
    for (const QString &body : repairs.program().bodiesNear(sign.line)) {
        repairs.insertAfter(repairs.tokens()[i - 1], QStringLiteral(" + %1.radius").arg(body));
        repairs.insertAfter(repairs.tokens()[i - 1], QStringLiteral(" - %1.radius").arg(body));
    }
}

/// A mass without its density.
void addDensity(RepairList &repairs, std::size_t i)
{
    const ProgramToken &token = repairs.tokens()[i];
    if (!(repairs.is(i, "=") || repairs.is(i, "return")) || repairs.lineOf(i + 1) != token.line)
        return;
    for (const std::size_t at : repairs.program().tokensOf(token.line)) {
        if (at > i + 1 && repairs.is(at, "radius") && repairs.is(at - 1, ".")
            && repairs.tokens()[at - 2].kind == ProgramToken::Kind::Name) {
            repairs.insertAfter(token,
                                QStringLiteral(" %1.density *").arg(repairs.tokens()[at - 2].text));
            return;
        }
    }
}

/// a / b + c where a / (b + c) is meant.
void addBrackets(RepairList &repairs, std::size_t i)
{
    const ProgramLines &program = repairs.program();
    if (!(repairs.is(i, "/") || repairs.is(i, "*")))
        return;
    const std::size_t sign = program.afterOperand(i + 1);
    if (sign == i + 1 || !(repairs.is(sign, "+") || repairs.is(sign, "-")))
        return;
    const std::size_t after = program.afterOperand(sign + 1);
    if (after == sign + 1)
        return;
    const qsizetype from = repairs.tokens()[i + 1].start;
    const qsizetype to = repairs.tokens()[after - 1].end();
    repairs.replace(repairs.tokens()[i].line, from, to,
                    QStringLiteral("(%1)").arg(program.source().mid(from, to - from)));
}

/// A sum in place of the greater or the less; a function too many; the angle of a quotient.
void changeCall(RepairList &repairs, std::size_t i)
{
    const ProgramLines &program = repairs.program();
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "(") || i == 0 || tokens[i - 1].kind != ProgramToken::Kind::Name)
        return;
    const int line = tokens[i].line;
    const std::size_t after = program.afterGroup(i);
    if (repairs.is(i - 2, ":") && after == i + 2)
        repairs.replace(line, tokens[i - 2].start, tokens[after - 1].end(), {});
    std::size_t comma = i + 1;
    while (comma < after && !repairs.is(comma, ","))
        comma = repairs.is(comma, "(") ? program.afterGroup(comma) : comma + 1;
    const std::size_t one = program.afterOperand(i + 1);
    if (repairs.is(i - 1, "atan") && repairs.is(one, "/")
        && program.afterOperand(one + 1) + 1 == after)
        repairs.replace(tokens[one], QStringLiteral(","));
    if (comma == after && repairs.is(i - 2, ".") && repairs.is(i - 3, "math"))
        repairs.replace(line, tokens[i - 3].start, tokens[i].start, {});
    if (comma + 1 >= after || comma == i + 1)
        return;
    const QString &source = program.source();
    const auto text = [&](std::size_t from, std::size_t to) {
        return source.mid(tokens[from].start, tokens[to - 1].end() - tokens[from].start);
    };
    const QString first = text(i + 1, comma);
    const QString second = text(comma + 1, after - 1);
    if (repairs.is(i - 1, "max") || repairs.is(i - 1, "min"))
        repairs.replace(line, tokens[i].start, tokens[after - 1].end(),
                        QStringLiteral("(%1 + %2, %1 + %2)").arg(first, second));
}

} // namespace

void repairTerms(RepairList &repairs, std::size_t i)
{
    dropOperand(repairs, i);
    addBrackets(repairs, i);
    changeCall(repairs, i);
}

void repairOmissions(RepairList &repairs, std::size_t i)
{
    addFactor(repairs, i);
    addRadius(repairs, i);
    addDensity(repairs, i);
}

} // namespace cradle
