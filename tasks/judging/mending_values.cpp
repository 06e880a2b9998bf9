// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/mending_values.h"

#include <algorithm>
#include <climits>
#include <utility>

namespace cradle {

namespace {

/// Values that a line gives; more mend anything.
constexpr std::size_t mostValues = 2;

} // namespace

MendingValues::MendingValues(const ProgramLines &program, const QString &reference,
                             const Moment &moment, const RanLines &ran, Aspect aspect,
                             std::function<bool(int)> isSound)
    : m_program(program)
    , m_ran(ran)
    , m_aspect(aspect)
    , m_assignments(assignmentsOf(m_program))
    , m_functions(functionsOf(m_program))
    , m_solver(program, reference, moment, aspect)
    , m_known(program, moment, std::move(isSound))
{
}

int MendingValues::line() const
{
    if (!m_solver.isWrong())
        return 0;
    std::vector<std::pair<std::vector<int>, int>> ordered;
    for (const int line : suspects()) {
        std::vector<int> place = placeOf(line, 0);
        place.push_back(INT_MAX); // what it calls is done before it
        ordered.emplace_back(std::move(place), line);
    }
    std::sort(ordered.begin(), ordered.end());
    for (const auto &[place, line] : ordered) {
        const std::vector<TokenRange> values = valuesAt(line);
        if (!values.empty() && values.size() <= mostValues && !isHandingOn(line)
            && !appliesGiven(m_program, line) && m_solver.mends(values)
            && !m_known.holds(line, values))
            return line;
    }
    return 0;
}

/// Where in a step a line runs: its own number, behind those of the lines that call its function.
std::vector<int> MendingValues::placeOf(int line, int depth) const
{
    constexpr int mostDepth = 6;
    const ProgramFunction *function = functionAt(m_functions, line);
    if (!function || function->name.isEmpty() || depth > mostDepth)
        return {line};
    for (const int call : m_ran.now) {
        const auto &row = m_program.tokensOf(call);
        const bool isOutside = call < function->first || call > function->last;
        if (isOutside && std::any_of(row.begin(), row.end(), [&](std::size_t i) {
                return m_program.tokens()[i].text == function->name && m_program.is(i + 1, "(");
            })) {
            std::vector<int> place = placeOf(call, depth + 1);
            place.push_back(line);
            return place;
        }
    }
    return {line};
}

bool MendingValues::knows(int line) const
{
    const std::vector<TokenRange> values = valuesAt(line);
    return m_ran.now.contains(line) && !values.empty() && m_known.holds(line, values);
}

std::set<int> MendingValues::suspects() const
{
    const std::vector<int> special = m_ran.special();
    std::set<int> lines(special.begin(), special.end());
    if (lines.empty() || m_aspect == Aspect::Motion)
        return m_ran.now;
    std::set<QString> called;
    for (std::size_t before = 0; before != lines.size();) {
        before = lines.size();
        for (const int line : lines) {
            for (const std::size_t i : m_program.tokensOf(line))
                called.insert(m_program.tokens()[i].text);
        }
        for (const ProgramFunction &function : m_functions) {
            for (int line = function.first; called.contains(function.name) && line <= function.last;
                 ++line) {
                if (m_ran.now.contains(line))
                    lines.insert(line);
            }
        }
    }
    return lines;
}

std::vector<TokenRange> MendingValues::valuesAt(int line) const
{
    std::vector<TokenRange> values;
    const auto addList = [&](std::size_t from) {
        while (true) {
            const std::size_t to = afterExpression(m_program, from);
            if (to == from)
                return;
            values.push_back({from, to});
            if (!m_program.is(to, ","))
                return;
            from = to + 1;
        }
    };
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line == line && each.from < each.to)
            values.push_back({each.from, each.to});
    }
    for (const std::size_t i : m_program.tokensOf(line)) {
        if (m_program.is(i, "return"))
            addList(i + 1);
        if (m_program.is(i, "{") && !m_program.is(i + 2, "="))
            addList(i + 1);
    }
    if (m_program.isCall(line)) {
        for (const std::size_t i : m_program.tokensOf(line)) {
            if (m_program.is(i + 1, "(") && values.empty()) {
                for (const TokenRange &given : argumentsOf(m_program, i))
                    values.push_back(given);
            }
        }
    }
    // One within another is changed by it.
    const bool areApart =
        std::adjacent_find(values.begin(), values.end(),
                           [](const auto &a, const auto &b) { return b.from < a.to; })
        == values.end();
    return areApart ? values : std::vector<TokenRange>{};
}

bool MendingValues::isHandingOn(int line) const
{
    bool isAny = false;
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line == line && !isHandedOn(m_program, each))
            return false;
        isAny = isAny || each.line == line;
    }
    return isAny;
}

} // namespace cradle
