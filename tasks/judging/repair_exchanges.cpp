// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_rows.h"
#include "tasks/judging/repair_list.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

/// The locals that are given a value in the lines before \p line, the nearest first.
QStringList localsBefore(const ProgramLines &program, int line)
{
    constexpr int near = 6;
    static const QRegularExpression header(QStringLiteral("\\bfunction\\b"));
    static const QRegularExpression local(QStringLiteral("^\\s*local\\s+(\\w+(\\s*,\\s*\\w+)*)"));
    QStringList names;
    for (int at = line - 1; at >= std::max(1, line - near); --at) {
        if (program.row(at).contains(header))
            break;
        const QString list = local.match(program.row(at)).captured(1);
        for (const QString &name : list.split(QLatin1Char(','), Qt::SkipEmptyParts))
            names.append(name.trimmed());
    }
    return names;
}

/// What a direction or a length is taken of: another vector that is at hand.
void exchangeObject(RepairList &repairs, std::size_t i)
{
    const ProgramLines &program = repairs.program();
    const std::size_t after = program.afterOperand(i);
    if (after < i + 4 || !repairs.is(after - 4, ":")
        || !(repairs.is(after - 3, "normalized") || repairs.is(after - 3, "length")))
        return;
    const ProgramToken &first = repairs.tokens()[i];
    if (repairs.is(i - 1, ".") || repairs.is(i - 1, ":"))
        return;
    for (const QString &name : localsBefore(program, first.line))
        repairs.replace(first.line, first.start, repairs.tokens()[after - 5].end(), name);
}

/// One coordinate for the distance.
void restoreLength(RepairList &repairs, std::size_t i)
{
    if (!repairs.is(i, "math") || !repairs.is(i + 2, "abs") || !repairs.is(i + 3, "("))
        return;
    const std::size_t after = repairs.program().afterGroup(i + 3);
    if (after != i + 8 || !repairs.is(i + 5, ".")
        || !(repairs.is(i + 6, "x") || repairs.is(i + 6, "y")))
        return;
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    repairs.replace(tokens[i].line, tokens[i].start, tokens[after - 1].end(),
                    tokens[i + 4].text + QStringLiteral(":length()"));
}

/// A number where the other coordinate belongs: vec(-v.x, 0).
void restoreCoordinate(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "vec") || !repairs.is(i + 1, "("))
        return;
    const std::size_t after = repairs.program().afterGroup(i + 1);
    std::size_t comma = i + 2;
    while (comma < after && !repairs.is(comma, ","))
        comma = repairs.is(comma, "(") ? repairs.program().afterGroup(comma) : comma + 1;
    if (comma + 2 >= after)
        return;
    const bool isSecond = comma + 3 == after;
    const std::size_t number = isSecond ? comma + 1 : i + 2;
    if (tokens[number].kind != ProgramToken::Kind::Number || (!isSecond && comma != i + 3))
        return;
    const QString &source = repairs.program().source();
    const std::size_t from = isSecond ? i + 2 : comma + 1;
    const std::size_t to = isSecond ? comma - 1 : after - 2;
    QString other = source.mid(tokens[from].start, tokens[to].end() - tokens[from].start);
    static const QRegularExpression end(QStringLiteral("[xy]$"));
    if (!other.contains(end))
        return;
    other.chop(1);
    if (other.startsWith(QLatin1Char('-')))
        other.remove(0, 1);
    repairs.replace(tokens[number], other + (isSecond ? QLatin1Char('y') : QLatin1Char('x')));
}

/// A radius where a wall and a radius belong.
void restoreWall(RepairList &repairs, std::size_t i)
{
    const ProgramToken &token = repairs.tokens()[i];
    const std::size_t after = repairs.program().afterOperand(i);
    if (token.kind != ProgramToken::Kind::Name
        || !(repairs.is(i - 1, "(") || repairs.is(i - 1, ","))
        || !(repairs.is(after, ")") || repairs.is(after, ","))
        || !(repairs.is(after - 1, "radius") || token.text.startsWith(u'r'))
        || !repairs.program().row(token.line).contains(QLatin1String("square.")))
        return;
    for (const char *wall :
         {"square.left + ", "square.bottom + ", "square.right - ", "square.top - "})
        repairs.replace(token.line, token.start, token.start, QLatin1String(wall));
}

/// What both circles have, taken of one: v₁ in place of v₁ − v₂.
void makeRelative(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (tokens[i].kind != ProgramToken::Kind::Name || !repairs.is(i + 1, ".")
        || !(repairs.is(i + 2, "velocity") || repairs.is(i + 2, "position"))
        || repairs.is(i + 3, "=") || repairs.is(i - 1, "."))
        return;
    const std::size_t after = repairs.program().afterOperand(i);
    const QString rest = repairs.program().source().mid(
        tokens[i + 1].start, tokens[after - 1].end() - tokens[i + 1].start);
    for (const QString &body : repairs.program().bodiesNear(tokens[i].line)) {
        if (body != tokens[i].text)
            repairs.insertAfter(tokens[after - 1], QStringLiteral(" - ") + body + rest);
    }
}

/// circles[1].density where c.density is meant.
void exchangeElement(RepairList &repairs, std::size_t i)
{
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    if (!repairs.is(i, "circles") || !repairs.is(i + 1, "[") || !repairs.is(i + 3, "]"))
        return;
    for (const QString &body : repairs.program().bodiesNear(tokens[i].line))
        repairs.replace(tokens[i].line, tokens[i].start, tokens[i + 3].end(), body);
}

/// Stands for a name while two are exchanged; no program has it.
constexpr QChar placeholder(1);

/// m1 for m2 and m2 for m1, wherever they stand in the line.
void exchangePartners(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    QStringList done;
    for (const std::size_t i : program.tokensOf(line)) {
        const ProgramToken &token = repairs.tokens()[i];
        if (token.kind != ProgramToken::Kind::Name || done.contains(token.text))
            continue;
        const QString partner = repairs.partnerOf(token.text);
        if (partner.isEmpty())
            continue;
        done << token.text << partner;
        QString row = program.row(line);
        row = withName(withName(row, token.text, placeholder), partner, token.text);
        row.replace(placeholder, partner);
        repairs.replace(line, program.startOf(line),
                        program.startOf(line) + program.row(line).size(), row);
    }
}

/// a.mass for b.mass and b.mass for a.mass, where what else the line takes of the two stays.
void exchangeFields(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    QStringList done;
    for (const std::size_t i : program.tokensOf(line)) {
        const QString owner = repairs.tokens()[i].text;
        const QString partner = repairs.is(i + 1, ".") ? repairs.partnerOf(owner) : QString();
        if (partner.isEmpty() || i + 2 >= repairs.tokens().size())
            continue;
        const QString field = repairs.tokens()[i + 2].text;
        if (done.contains(field))
            continue;
        done << field;
        QString row = program.row(line);
        bool isOfBoth = false;
        std::vector<std::size_t> tokens = program.tokensOf(line);
        std::reverse(tokens.begin(), tokens.end());
        for (const std::size_t k : tokens) {
            const ProgramToken &token = repairs.tokens()[k];
            if ((token.text != owner && token.text != partner) || !repairs.is(k + 1, ".")
                || k + 2 >= repairs.tokens().size() || repairs.tokens()[k + 2].text != field)
                continue;
            isOfBoth = isOfBoth || token.text == partner;
            row.replace(token.start - program.startOf(line), token.text.size(),
                        token.text == owner ? partner : owner);
        }
        if (isOfBoth)
            repairs.replace(line, program.startOf(line),
                            program.startOf(line) + program.row(line).size(), row);
    }
}

/// What one line says of the first circle and the next of the second, said the other way round.
void exchangeWithNext(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    if (line >= program.count())
        return;
    const QString row = program.row(line);
    const QString next = program.row(line + 1);
    QStringList done;
    for (const std::size_t i : program.tokensOf(line)) {
        const ProgramToken &token = repairs.tokens()[i];
        if (token.kind != ProgramToken::Kind::Name || done.contains(token.text))
            continue;
        done << token.text;
        const QString partner = repairs.partnerOf(token.text);
        const auto names = [](const QString &text, const QString &name) {
            return withName(text, name, {}) != text;
        };
        if (partner.isEmpty() || names(row, partner) || names(next, token.text)
            || !names(next, partner))
            continue;
        // Of two that say the same of each only the order changes.
        const QString other = withName(row, token.text, partner);
        if (other == next)
            continue;
        repairs.replace(line, program.startOf(line), program.startOf(line + 1) + next.size(),
                        other + QLatin1Char('\n') + withName(next, partner, token.text));
    }
}

/// u[1] for u[2] and u[2] for u[1] in what the line gives.
void exchangeIndices(RepairList &repairs, int line)
{
    static const QRegularExpression index(QStringLiteral("\\[([12])\\]"));
    const ProgramLines &program = repairs.program();
    const QString row = program.row(line);
    const qsizetype behind = row.indexOf(QLatin1Char('=')) + 1;
    QString given = row.mid(behind);
    if (behind == 0 || !given.contains(index))
        return;
    given.replace(QLatin1String("[1]"), QString(placeholder));
    given.replace(QLatin1String("[2]"), QLatin1String("[1]"));
    given.replace(placeholder, QLatin1String("[2]"));
    const qsizetype from = program.startOf(line);
    repairs.replace(line, from + behind, from + row.size(), given);
}

/// a = b, then b = a, where both at once are meant.
void assignAtOnce(RepairList &repairs, int line)
{
    static const QRegularExpression assignment(
        QStringLiteral("^(\\s*)([\\w.\\[\\]]+)\\s*=\\s*([^=].*)$"));
    const ProgramLines &program = repairs.program();
    if (line >= program.count())
        return;
    const auto one = assignment.match(program.row(line));
    const auto two = assignment.match(program.row(line + 1));
    if (!one.hasMatch() || !two.hasMatch() || !two.captured(3).contains(one.captured(2)))
        return;
    const qsizetype from = program.startOf(line);
    // Who takes what has changed is at fault.
    repairs.replace(line + 1, from, program.startOf(line + 1) + program.row(line + 1).size(),
                    QStringLiteral("%1%2, %3 = %4, %5")
                        .arg(one.captured(1), one.captured(2), two.captured(2), one.captured(3),
                             two.captured(3)));
}

/// A way out of a loop or a function that is taken too early.
void goOn(RepairList &repairs, int line)
{
    static const QRegularExpression leave(
        QStringLiteral("^\\s*(do\\s+)?(break|return)(\\s+end)?\\s*$"));
    const ProgramLines &program = repairs.program();
    const QString row = program.row(line);
    if (row.contains(leave))
        repairs.replace(line, program.startOf(line), program.startOf(line) + row.size(), {});
}

} // namespace

void repairExchanges(RepairList &repairs, std::size_t i)
{
    exchangeObject(repairs, i);
    restoreLength(repairs, i);
    restoreCoordinate(repairs, i);
    restoreWall(repairs, i);
    makeRelative(repairs, i);
    exchangeElement(repairs, i);
}

void repairOrder(RepairList &repairs, int line)
{
    exchangePartners(repairs, line);
    exchangeFields(repairs, line);
    exchangeWithNext(repairs, line);
    exchangeIndices(repairs, line);
    assignAtOnce(repairs, line);
    goOn(repairs, line);
}

} // namespace cradle
