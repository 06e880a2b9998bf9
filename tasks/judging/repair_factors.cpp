// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

namespace cradle {

namespace {

bool isSum(const RepairList &repairs, std::size_t i)
{
    return repairs.is(i, "+") || (repairs.is(i, "-") && repairs.endsOperand(i - 1));
}

bool isProduct(const RepairList &repairs, std::size_t i)
{
    return repairs.is(i, "*") || repairs.is(i, "/");
}

/// Whether a sum may begin at \p i.
bool beginsSum(const RepairList &repairs, std::size_t i)
{
    return repairs.is(i - 1, "=") || repairs.is(i - 1, "(") || repairs.is(i - 1, ",")
           || repairs.is(i - 1, "return") || repairs.is(i - 1, "<") || repairs.is(i - 1, ">");
}

/// The token after the product that begins at \p i, in the same line.
std::size_t afterProduct(const RepairList &repairs, std::size_t i)
{
    std::size_t after = repairs.program().afterOperand(i);
    if (after == i)
        return i;
    const int line = repairs.tokens()[i].line;
    while (isProduct(repairs, after) || repairs.is(after, "^")) {
        const std::size_t next = repairs.program().afterOperand(after + 1);
        if (next == after + 1 || repairs.tokens()[next - 1].line != line)
            break;
        after = next;
    }
    return after;
}

/// The first term of a sum too many.
void dropFirstTerm(RepairList &repairs, std::size_t i)
{
    if (!beginsSum(repairs, i))
        return;
    const std::size_t sign = afterProduct(repairs, i);
    if (sign == i || !isSum(repairs, sign) || sign + 1 >= repairs.tokens().size())
        return;
    repairs.replace(repairs.tokens()[i].line, repairs.tokens()[i].start,
                    repairs.tokens()[sign + 1].start, {});
}

/// A later term of a sum too many, with all of its factors.
void dropTerm(RepairList &repairs, std::size_t i)
{
    if (!isSum(repairs, i))
        return;
    const std::size_t after = afterProduct(repairs, i + 1);
    if (after > i + 1)
        repairs.replace(repairs.tokens()[i].line, repairs.tokens()[i].start,
                        repairs.tokens()[after - 1].end(), {});
}

/// More than one factor too many at the end: * 180 / math.pi.
void dropFactors(RepairList &repairs, std::size_t i)
{
    if (!isProduct(repairs, i))
        return;
    const std::size_t first = repairs.program().afterOperand(i + 1);
    if (first == i + 1 || !isProduct(repairs, first))
        return;
    const std::size_t after = afterProduct(repairs, i + 1);
    repairs.replace(repairs.tokens()[i].line, repairs.tokens()[i].start,
                    repairs.tokens()[after - 1].end(), {});
}

/// A + B / c where (A + B) / c is meant; (A + B) / 2 for masses that act together.
void gatherSum(RepairList &repairs, std::size_t i)
{
    if (!beginsSum(repairs, i) && !isSum(repairs, i - 1))
        return;
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    const std::size_t sign = afterProduct(repairs, i);
    if (sign == i || !isSum(repairs, sign))
        return;
    std::size_t at = repairs.program().afterOperand(sign + 1);
    while (repairs.is(at, "*"))
        at = repairs.program().afterOperand(at + 1);
    if (!repairs.is(at, "/"))
        return;
    repairs.replace(tokens[i].line, tokens[i].start, tokens[at - 1].end(),
                    QStringLiteral("(%1)").arg(repairs.program().source().mid(
                        tokens[i].start, tokens[at - 1].end() - tokens[i].start)));
}

/// (A + B) / 2 where two things share what acts: A B / (A + B).
void shareSum(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "("))
        return;
    const std::size_t after = repairs.program().afterGroup(i);
    const std::size_t sign = repairs.program().afterOperand(i + 1);
    if (sign == i + 1 || !repairs.is(sign, "+")
        || repairs.program().afterOperand(sign + 1) + 1 != after)
        return;
    const QString &source = repairs.program().source();
    const QString one =
        source.mid(tokens[i + 1].start, tokens[sign - 1].end() - tokens[i + 1].start);
    const QString two =
        source.mid(tokens[sign + 1].start, tokens[after - 2].end() - tokens[sign + 1].start);
    const std::size_t end =
        repairs.is(after, "/") ? repairs.program().afterOperand(after + 1) : after;
    repairs.replace(tokens[i].line, tokens[i].start, tokens[end - 1].end(),
                    QStringLiteral("(%1 * %2 / (%1 + %2))").arg(one, two));
}

/// What one of two values is divided or multiplied by, for the other, too.
void copyFactor(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!(repairs.is(i, "=") || repairs.is(i, "(")))
        return;
    const std::size_t one = repairs.program().afterOperand(i + 1);
    const std::size_t comma = one == i + 1 ? one : afterProduct(repairs, i + 1);
    if (!repairs.is(comma, ",") || one == i + 1)
        return;
    const std::size_t two = repairs.program().afterOperand(comma + 1);
    if (two == comma + 1 || tokens[two - 1].line != tokens[i].line)
        return;
    const QString &source = repairs.program().source();
    if (one < comma && !isProduct(repairs, two))
        repairs.insertAfter(
            tokens[two - 1],
            QLatin1Char(' ')
                + source.mid(tokens[one].start, tokens[comma - 1].end() - tokens[one].start));
    const std::size_t end = afterProduct(repairs, comma + 1);
    if (one == comma && end > two)
        repairs.insertAfter(
            tokens[one - 1],
            QLatin1Char(' ')
                + source.mid(tokens[two].start, tokens[end - 1].end() - tokens[two].start));
}

/// A value that was worked out for this and then forgotten.
void useForgotten(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "=") || repairs.lineOf(i + 1) != tokens[i].line)
        return;
    const std::size_t after = afterExpression(repairs.program(), i + 1);
    for (const QString &name : repairs.program().forgotten(tokens[i].line)) {
        const int line = tokens[i].line;
        repairs.replaceTelling(line, tokens[i].end(), tokens[i].end(),
                               QStringLiteral(" %1 *").arg(name));
        if (after == i + 1)
            continue;
        const qsizetype end = tokens[after - 1].end();
        repairs.replaceTelling(line, end, end, QStringLiteral(" / %1").arg(name));
        repairs.replaceTelling(line, tokens[i + 1].start, end, name);
    }
}

/// One more or less: of the turns of a loop, of an index that is handed on.
void countOther(RepairList &repairs, std::size_t i)
{
    const ProgramToken &token = repairs.tokens()[i];
    const auto &line = repairs.program().tokensOf(token.line);
    bool isCount = false;
    const int value = token.text.toInt(&isCount);
    if (token.kind == ProgramToken::Kind::Number && isCount && repairs.is(line.front(), "for")) {
        repairs.replace(token, QString::number(value + 1));
        repairs.replace(token, QString::number(value - 1));
    }
    const bool isIndex = token.is("i") || token.is("j") || token.is("k");
    if (isIndex && (repairs.is(i - 1, ",") || repairs.is(i - 1, "("))
        && (repairs.is(i + 1, ")") || repairs.is(i + 1, ","))) {
        repairs.insertAfter(token, QStringLiteral(" - 1"));
        repairs.insertAfter(token, QStringLiteral(" + 1"));
    }
}

} // namespace

void repairFactors(RepairList &repairs, std::size_t i)
{
    dropFirstTerm(repairs, i);
    dropTerm(repairs, i);
    dropFactors(repairs, i);
    gatherSum(repairs, i);
    countOther(repairs, i);
    copyFactor(repairs, i);
    useForgotten(repairs, i);
    shareSum(repairs, i);
}

void addCoordinate(RepairList &repairs, std::size_t i)
{
    if (!beginsSum(repairs, i))
        return;
    const std::size_t after = afterProduct(repairs, i);
    if (after < i + 2 || isSum(repairs, after))
        return;
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    QString other;
    bool isOther = false;
    for (std::size_t at = i; at < after; ++at) {
        const QString &text = tokens[at].text;
        QString partner = text;
        partner.replace(QLatin1Char('x'), QLatin1Char('y'));
        const bool isCoordinate = tokens[at].kind == ProgramToken::Kind::Name && partner != text
                                  && repairs.program().hasName(partner);
        other += QLatin1Char(' ') + (isCoordinate ? partner : text);
        isOther = isOther || isCoordinate;
    }
    if (isOther)
        repairs.insertAfter(tokens[after - 1], QStringLiteral(" +") + other);
}

void scaleTerm(RepairList &repairs, std::size_t i)
{
    if (!beginsSum(repairs, i) && !isSum(repairs, i - 1))
        return;
    const ProgramToken &first = repairs.tokens()[i];
    if (first.kind == ProgramToken::Kind::Number || repairs.program().afterOperand(i) == i)
        return;
    const std::size_t after = afterProduct(repairs, i);
    if (!isSum(repairs, after) && !isSum(repairs, i - 1))
        return;
    // What a function is given was worked out where it is called.
    const ProgramFunction *function = functionAt(repairs.functions(), first.line);
    if (function && function->parameters.contains(first.text) && !repairs.is(i + 1, "."))
        return;
    for (const char *factor : {"2 * ", "restitution * "})
        repairs.replace(first.line, first.start, first.start, QLatin1String(factor));
}

} // namespace cradle
