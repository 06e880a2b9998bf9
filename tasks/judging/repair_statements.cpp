// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_rows.h"
#include "tasks/judging/repair_list.h"

#include <QRegularExpression>

namespace cradle {

namespace {

void changeCondition(RepairList &repairs, std::size_t i)
{
    const ProgramToken &word = repairs.tokens()[i];
    const bool isBetween = i > 0 && i + 1 < repairs.tokens().size();
    if (isBetween && (word.is("and") || word.is("or"))) {
        const auto stops = [&](const ProgramToken &t) {
            return t.kind == ProgramToken::Kind::Keyword && !t.is("not");
        };
        std::size_t first = i;
        while (first > 0 && !stops(repairs.tokens()[first - 1]))
            --first;
        std::size_t last = i + 1;
        while (last < repairs.tokens().size() && !stops(repairs.tokens()[last]))
            ++last;
        repairs.replace(word.line, repairs.tokens()[first].start, repairs.tokens()[i + 1].start,
                        {});
        repairs.replace(word.line, repairs.tokens()[i - 1].end(), repairs.tokens()[last - 1].end(),
                        {});
        repairs.replace(word, word.is("and") ? QStringLiteral("or") : QStringLiteral("and"));
    }
    if (word.is("if") || word.is("elseif")) {
        std::size_t then = i + 1;
        while (then < repairs.tokens().size() && !repairs.tokens()[then].is("then"))
            ++then;
        if (then >= repairs.tokens().size())
            return;
        for (const QString &name : repairs.program().forgotten(word.line))
            repairs.replaceTelling(word.line, repairs.tokens()[then - 1].end(),
                                   repairs.tokens()[then - 1].end(),
                                   QStringLiteral(" and %1").arg(name));
        for (const char *verdict : {"true", "false"})
            repairs.replace(word.line, repairs.tokens()[i + 1].start,
                            repairs.tokens()[then - 1].end(), QLatin1String(verdict));
    }
}

/// The token after the last of the right side of the assignment whose sign is \p i, in its line.
std::size_t afterRightSide(const RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    std::size_t at = i + 1;
    while (at < tokens.size() && tokens[at].line == tokens[i].line && !tokens[at].is(";")
           && !tokens[at].is("end") && !tokens[at].is("function"))
        ++at;
    return at;
}

/// The comma between two values from token \p from on; \p to if there are not two.
std::size_t commaOfTwo(const RepairList &repairs, std::size_t from, std::size_t to)
{
    std::size_t comma = to;
    for (std::size_t at = from; at < to; ++at) {
        if (repairs.is(at, "(") || repairs.is(at, "[")) {
            at = repairs.program().afterGroup(at) - 1;
        } else if (repairs.is(at, ",")) {
            if (comma != to)
                return to;
            comma = at;
        }
    }
    return comma;
}

/// What an assignment gives: of length 1, the other way round, upside down, exchanged.
void changeRightSide(RepairList &repairs, std::size_t i)
{
    const bool returns = repairs.is(i, "return");
    if (!(repairs.is(i, "=") || returns))
        return;
    const int line = repairs.tokens()[i].line;
    std::size_t after = afterRightSide(repairs, i);
    if (repairs.is(after - 1, ",")) // the next value stands in the next line
        --after;
    if (after == i + 1)
        return;
    const qsizetype from = repairs.tokens()[i + 1].start;
    const qsizetype end = repairs.tokens()[after - 1].end();
    const QString &source = repairs.program().source();
    const QString right = source.mid(from, end - from);
    const std::size_t comma = commaOfTwo(repairs, i + 1, after);
    if (comma != after) {
        const QString one = source.mid(from, repairs.tokens()[comma - 1].end() - from);
        const qsizetype second = repairs.tokens()[comma + 1].start;
        const QString two = source.mid(second, end - second);
        if (!returns)
            repairs.replace(line, from, end,
                            QStringLiteral("(%1) / ((%1)^2 + (%2)^2)^0.5, (%2) / ((%1)^2 + "
                                           "(%2)^2)^0.5")
                                .arg(one, two));
        repairs.replace(line, from, from + one.size(), QStringLiteral("-(%1)").arg(one));
        repairs.replace(line, second, end, QStringLiteral("-(%1)").arg(two));
        return;
    }
    if (returns)
        return;
    static const QRegularExpression scalar(QStringLiteral("math\\.|radius|density|^[\\d.]+$"));
    if (!right.contains(scalar))
        repairs.replace(line, from, end, QStringLiteral("(%1):normalized()").arg(right));
    repairs.replace(line, from, end, QStringLiteral("-(%1)").arg(right));
}

/// Whether a line is one whole statement.
bool isStatement(const ProgramLines &program, int line)
{
    static const QRegularExpression statement(
        QStringLiteral("^\\s*(local\\s+)?[\\w.,\\s\\[\\]]+(=[^=]|\\().*[^,(]$"));
    return line >= 1 && line <= program.count() && statement.match(program.row(line)).hasMatch();
}

/// All that the line says of one circle, said of another that is named nearby.
void exchangeBody(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    const QStringList bodies = program.bodiesNear(line);
    const QString row = program.row(line);
    for (const QString &from : bodies) {
        for (const QString &to : bodies) {
            if (to != from)
                repairs.replace(line, program.startOf(line), program.startOf(line) + row.size(),
                                withName(row, from, to));
        }
    }
}

/// A pair is one and another: for j = i + 1, #circles within for i = 1, #circles.
void changeLoop(RepairList &repairs, std::size_t i)
{
    if (!repairs.is(i, "for") || !repairs.is(i + 2, "=") || !repairs.is(i + 4, ","))
        return;
    const ProgramToken &first = repairs.tokens()[i + 3];
    if (first.kind == ProgramToken::Kind::Name)
        repairs.replaceTelling(first.line, first.end(), first.end(), QStringLiteral(" + 1"));
}

} // namespace

void repairStatements(RepairList &repairs, std::size_t i)
{
    changeCondition(repairs, i);
    changeLoop(repairs, i);
    changeRightSide(repairs, i);
}

void repairScales(RepairList &repairs, std::size_t i)
{
    const bool returns = repairs.is(i, "return");
    if (!(repairs.is(i, "=") || returns))
        return;
    const std::size_t after = afterRightSide(repairs, i);
    if (after == i + 1 || commaOfTwo(repairs, i + 1, after) != after)
        return;
    const qsizetype from = repairs.tokens()[i + 1].start;
    const qsizetype end = repairs.tokens()[after - 1].end();
    const QString right = repairs.program().source().mid(from, end - from);
    if (!returns && right.contains(QLatin1Char('+')))
        repairs.replace(repairs.tokens()[i].line, from, end, QStringLiteral("(%1) / 2").arg(right));
    // What is called so is one.
    const int line = repairs.tokens()[i].line;
    const ProgramFunction *function = functionAt(repairs.functions(), line);
    const QString name = !returns   ? repairs.tokens()[i - (i > 0 ? 1 : 0)].text
                         : function ? function->name
                                    : QString();
    if (name.contains(QLatin1String("inv"), Qt::CaseInsensitive))
        repairs.replaceTelling(line, from, end, QStringLiteral("1 / (%1)").arg(right));
    if (right.contains(QLatin1Char('*')) || (!returns && right.contains(QLatin1Char('/'))))
        repairs.replace(
            repairs.tokens()[i].line, from, end,
            (returns ? QStringLiteral("1 / (%1)") : QStringLiteral("2 * (%1)")).arg(right));
}

void dropLine(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    const auto &row = program.tokensOf(line);
    const bool isFunction = std::any_of(row.begin(), row.end(),
                                        [&](std::size_t i) { return program.is(i, "function"); });
    // Of two that are alike the second is one too many.
    const bool isRepeated = line < program.count() && program.row(line) == program.row(line + 1);
    if (isStatement(program, line) && !isFunction && !isRepeated)
        repairs.replace(line, program.startOf(line),
                        program.startOf(line) + program.row(line).size(), {});
}

void repairLine(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    if (line < 1 || line > program.count())
        return;
    exchangeBody(repairs, line);
    if (!isStatement(program, line))
        return;
    const QString row = program.row(line);
    const qsizetype from = program.startOf(line);
    if (!isStatement(program, line + 1))
        return;
    const QString next = program.row(line + 1);
    repairs.replace(line, from, from + row.size() + 1 + next.size(),
                    next + QLatin1Char('\n') + row);
}

} // namespace cradle
