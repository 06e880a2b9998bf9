// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

namespace cradle {

namespace {

/// m₁ m₂ for m₁ m₂ / (m₁ + m₂), which two share.
void shareProduct(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "*") || i == 0 || i + 1 >= tokens.size())
        return;
    const QString &one = tokens[i - 1].text;
    const QString &two = tokens[i + 1].text;
    if (repairs.partnerOf(one) == two && !repairs.is(i + 2, "/"))
        repairs.insertAfter(tokens[i + 1], QStringLiteral(" / (%1 + %2)").arg(one, two));
}

/// r₁² + r₂² for (r₁ + r₂)².
void squareSum(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    const std::size_t power = repairs.program().afterOperand(i);
    if (power == i || !repairs.is(power, "^") || !repairs.is(power + 1, "2")
        || !repairs.is(power + 2, "+") || repairs.is(i - 1, "."))
        return;
    const std::size_t second = repairs.program().afterOperand(power + 3);
    if (second == power + 3 || !repairs.is(second, "^") || !repairs.is(second + 1, "2"))
        return;
    const QString &source = repairs.program().source();
    const auto text = [&](std::size_t from, std::size_t to) {
        return source.mid(tokens[from].start, tokens[to - 1].end() - tokens[from].start);
    };
    repairs.replace(tokens[i].line, tokens[i].start, tokens[second + 1].end(),
                    QStringLiteral("(%1 + %2) ^ 2").arg(text(i, power), text(power + 3, second)));
}

/// The whole timestep where a loop makes several parts of it.
void divideStep(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "=") || i + 1 >= tokens.size()
        || !repairs.program().timesteps().contains(tokens[i + 1].text)
        || repairs.lineOf(i + 2) == tokens[i].line)
        return;
    const QStringList &parts = repairs.program().countsOfLoops();
    for (const QString &count : parts)
        repairs.insertAfter(tokens[i + 1], QStringLiteral(" / ") + count);
}

} // namespace

QHash<QString, QString> RepairList::pairsOf(const ProgramLines &program,
                                            const std::vector<ProgramAssignment> &assignments)
{
    QHash<QString, QString> pairs;
    for (std::size_t k = 0; k + 1 < assignments.size(); ++k) {
        const ProgramAssignment &one = assignments[k];
        const ProgramAssignment &two = assignments[k + 1];
        bool isAlike = one.line == two.line && one.last + 2 == two.target && one.from < one.to
                       && two.to - two.from == one.to - one.from && program.isNewName(one.target)
                       && !pairs.contains(one.name);
        bool isOfTwo = false; // what is given the same is no pair
        for (std::size_t at = 0; isAlike && at < one.to - one.from; ++at) {
            const ProgramToken &x = program.tokens()[one.from + at];
            const ProgramToken &y = program.tokens()[two.from + at];
            isAlike = x.kind == y.kind && (x.kind == ProgramToken::Kind::Name || x.text == y.text);
            isOfTwo = isOfTwo || x.text != y.text;
        }
        if (!isAlike || !isOfTwo)
            continue;
        pairs.insert(one.name, two.name);
        pairs.insert(two.name, one.name);
    }
    return pairs;
}

QString RepairList::partnerOf(const QString &name) const
{
    static const QHash<QString, QString> words{{QStringLiteral("one"), QStringLiteral("two")},
                                               {QStringLiteral("two"), QStringLiteral("one")},
                                               {QStringLiteral("self"), QStringLiteral("other")},
                                               {QStringLiteral("other"), QStringLiteral("self")}};
    if (m_program.hasName(words.value(name)))
        return words.value(name);
    for (const auto &[one, two] : circleEnds) {
        QString partner = name;
        QChar &end = partner.back();
        if (end != QLatin1Char(one) && end != QLatin1Char(two))
            continue;
        end = QLatin1Char(end == QLatin1Char(one) ? two : one);
        if (m_program.hasName(partner))
            return partner;
    }
    // Many number only what is of the second.
    const QString other = name.endsWith(QLatin1Char('2')) ? name.chopped(1) : name + u'2';
    return m_program.hasName(other) ? other : m_declared.value(name);
}

void repairPairs(RepairList &repairs, std::size_t i)
{
    shareProduct(repairs, i);
    squareSum(repairs, i);
    divideStep(repairs, i);
}

void scaleValue(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    const std::vector<std::size_t> &row = program.tokensOf(line);
    QHash<QString, std::vector<std::size_t>> factors; // in the order in which they stand
    QStringList names;
    bool isRight = false;
    for (const std::size_t i : row) {
        const ProgramToken &token = program.tokens()[i];
        isRight = isRight || token.is("=");
        const bool isValue = isRight && token.kind == ProgramToken::Kind::Name
                             && !program.is(i - 1, ".") && !program.is(i - 1, ":")
                             && (program.is(i + 1, "*") || program.is(i - 1, "*"))
                             && program.afterOperand(i) == i + 1;
        if (!isValue)
            continue;
        if (!names.contains(token.text))
            names.append(token.text);
        factors[token.text].push_back(i);
    }
    for (const QString &name : names) {
        const std::vector<std::size_t> &places = factors[name];
        if (places.size() < 2)
            continue;
        const qsizetype from = program.tokens()[places.front()].start;
        const qsizetype to = program.tokens()[places.back()].end();
        QString text = program.source().mid(from, to - from);
        for (auto at = places.rbegin(); at != places.rend(); ++at)
            text.insert(program.tokens()[*at].start - from, QLatin1String("2 * "));
        repairs.replace(line, from, to, text);
    }
}

} // namespace cradle
