// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/asked_values.h"

#include <algorithm>

namespace cradle {

namespace {

bool isComparison(const ProgramToken &token)
{
    return token.is("<") || token.is(">") || token.is("<=") || token.is(">=");
}

} // namespace

AskedValues::AskedValues(const ProgramLines &program)
    : m_program(program)
    , m_assignments(assignmentsOf(program))
    , m_functions(functionsOf(program))
    , m_radii(copiesOf(program, m_assignments, {QStringLiteral("radius")}))
{
}

bool AskedValues::isOfRadius(std::size_t from, std::size_t to) const
{
    const QStringList values = valuesIn(m_program, from, to);
    for (std::size_t i = from; i < to; ++i) {
        if (m_program.is(i, "radius"))
            return true;
    }
    return std::any_of(values.begin(), values.end(),
                       [&](const QString &value) { return m_radii.contains(value); });
}

std::optional<AskedValue> AskedValues::valueAt(std::size_t i, int line) const
{
    const ProgramAssignment *found =
        lastAbove(line, m_program.tokens()[i].text, m_program, m_assignments, m_functions,
                  [&](const ProgramAssignment &each) { return m_program.isNewName(each.target); });
    return found ? std::optional(AskedValue{found->line, isOfRadius(found->from, found->to)})
                 : std::nullopt;
}

std::vector<AskedValue> AskedValues::of(int line) const
{
    std::vector<AskedValue> values;
    const std::vector<ProgramToken> &tokens = m_program.tokens();
    for (const std::size_t i : m_program.tokensOf(line)) {
        if (!isComparison(tokens[i]) || i < 2 || i + 2 >= tokens.size())
            continue;
        const auto isAlone = [&](std::size_t at) {
            const auto bounds = [](const ProgramToken &t) {
                return t.kind == ProgramToken::Kind::Keyword || t.is("(") || t.is(")")
                       || isComparison(t);
            };
            return bounds(tokens[at - 1]) && bounds(tokens[at + 1]);
        };
        for (const auto &[name, number] : {std::pair{i - 1, i + 1}, std::pair{i + 1, i - 1}}) {
            if (tokens[name].kind != ProgramToken::Kind::Name
                || tokens[number].kind != ProgramToken::Kind::Number || !isAlone(name)
                || !isAlone(number))
                continue;
            if (const auto value = valueAt(name, line))
                values.push_back(*value);
        }
    }
    return values;
}

bool AskedValues::asksReach(int line) const
{
    const std::vector<AskedValue> values = of(line);
    const std::vector<std::size_t> &row = m_program.tokensOf(line);
    return std::any_of(values.begin(), values.end(), [](const auto &v) { return v.isReach; })
           || (!row.empty() && isOfRadius(row.front(), row.back() + 1));
}

int AskedValues::valueBehind(int line, bool isReach) const
{
    int found = 0;
    for (const std::size_t i : m_program.tokensOf(line)) {
        // A part of a vector is asked, not what the whole of it is.
        if (m_program.tokens()[i].kind != ProgramToken::Kind::Name || m_program.is(i + 1, ".")
            || m_program.is(i + 1, ":"))
            continue;
        const auto value = valueAt(i, line);
        if (!value || value->isReach != isReach || value->line == found)
            continue;
        if (found != 0)
            return 0;
        found = value->line;
    }
    return found;
}

bool AskedValues::isJoined(int line) const
{
    const std::vector<std::size_t> &row = m_program.tokensOf(line);
    return std::any_of(row.begin(), row.end(), [&](std::size_t i) {
        return m_program.is(i, "and") || m_program.is(i, "or");
    });
}

} // namespace cradle
