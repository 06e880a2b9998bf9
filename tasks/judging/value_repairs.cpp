// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/value_repairs.h"

#include "tasks/judging/quantities.h"
#include "tasks/judging/repair_list.h"

#include <algorithm>
#include <set>

namespace cradle {

namespace {

/// Of one program; more are of many values that have nothing to do with the fault.
constexpr std::size_t mostValueRepairs = 300;

/// Tokens \p from to \p to without \p to.
struct Value {
    std::size_t from;
    std::size_t to;
};

/// What line \p line gives, returns or hands on to a function.
std::vector<Value> valuesAt(const RepairList &repairs, int line, bool withArguments)
{
    const ProgramLines &program = repairs.program();
    std::vector<Value> values;
    const auto addList = [&](std::size_t from) {
        while (true) {
            const std::size_t to = afterExpression(program, from);
            if (to == from)
                return;
            values.push_back({from, to});
            if (!program.is(to, ","))
                return;
            from = to + 1;
        }
    };
    for (const ProgramAssignment &each : repairs.assignments()) {
        if (each.line == line && each.from < each.to)
            values.push_back({each.from, each.to});
    }
    for (const std::size_t i : program.tokensOf(line)) {
        const bool calls = withArguments && program.is(i, "(") && i > 0
                           && program.tokens()[i - 1].kind == ProgramToken::Kind::Name;
        if (program.is(i, "return") || calls)
            addList(i + 1);
    }
    return values;
}

/// Whether a value may be one that the fault is about: a motion needs numbers and gravity, a mass
/// is worked out.
bool isSuspicious(const ProgramLines &program, const Value &value, Aspect aspect, Suspect suspect)
{
    const auto any = [&](const auto &fits) {
        for (std::size_t i = value.from; i < value.to; ++i) {
            if (fits(program.tokens()[i]))
                return true;
        }
        return false;
    };
    if (aspect == Aspect::Motion)
        return any([](const ProgramToken &token) {
            return token.kind == ProgramToken::Kind::Number || token.is("gravity")
                   || token.is("velocity") || token.is("v");
        });
    if (suspect == Suspect::Masses)
        return any([](const ProgramToken &token) {
            return token.is("*") || token.is("/") || token.is("^") || token.is("density");
        });
    return true;
}

/// The program, which stops as soon as the value is none of \p quantities.
QString stopping(const QString &source, qsizetype from, qsizetype to, const QStringList &quantities)
{
    static const QString watch = QStringLiteral(
        "local other_quantity = {} local function is_quantity(v, ...) local any = false "
        "for k, q in ipairs({...}) do local near = type(v) == type(q) and "
        "(type(v) == 'number' and math.abs(v - q) <= 1e-9 * (1 + math.abs(q)) or "
        "type(v) == 'vector' and (v - q):length() <= 1e-9) "
        "if not near then other_quantity[k] = true end any = any or not other_quantity[k] end "
        "if not any then error('') end return v end ");
    QString changed = source;
    changed.replace(from, to - from,
                    QStringLiteral("is_quantity(%1, %2)")
                        .arg(source.mid(from, to - from), quantities.join(QLatin1String(", "))));
    return watch + changed;
}

/// Whether a value is always the same of \p quantities, up to the moment.
bool isSound(const QString &source, qsizetype from, qsizetype to, const QStringList &quantities,
             const Moment &moment)
{
    if (quantities.isEmpty())
        return false;
    const QString program = stopping(source, from, to, quantities);
    Probe probe(&program, moment.stage, true);
    for (qint64 k = 0; k < moment.step; ++k) {
        if (!probe.step())
            return false;
    }
    return probe.runs();
}

} // namespace

std::vector<Repair> valueRepairsOf(const QString &source, const std::vector<int> &lines,
                                   Aspect aspect, Suspect suspect, const Moment &moment,
                                   ValueChange change)
{
    const ProgramLines program(source);
    RepairList repairs(program, true, mostValueRepairs);
    const std::set<int> inOrder(lines.begin(), lines.end());
    std::vector<int> order(inOrder.begin(), inOrder.end());
    if (suspect == Suspect::Masses)
        std::reverse(order.begin(), order.end());
    const bool withArguments = aspect == Aspect::Walls || aspect == Aspect::Motion;
    for (const int line : order) {
        const std::vector<Value> values = valuesAt(repairs, line, withArguments);
        if (values.empty())
            continue;
        const NamesAtHand names(program, repairs.assignments(), repairs.functions(), line);
        const Quantities quantities(names, program.timesteps(), aspect, suspect);
        for (const Value &value : values) {
            const qsizetype from = program.tokens()[value.from].start;
            const qsizetype to = program.tokens()[value.to - 1].end();
            const QString text = source.mid(from, to - from);
            if (!isSuspicious(program, value, aspect, suspect) || quantities.isPart(text)
                || isSound(source, from, to, quantities.sound(), moment))
                continue;
            const QStringList others = change == ValueChange::Completed
                                           ? quantities.completed(text, program.forgotten(line))
                                           : quantities.all();
            for (const QString &other : others)
                repairs.replace(line, from, to, other);
        }
    }
    return repairs.take();
}

} // namespace cradle
