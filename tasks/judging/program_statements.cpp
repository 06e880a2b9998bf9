// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_statements.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

bool isName(const ProgramLines &program, std::size_t i)
{
    return i < program.tokens().size() && program.tokens()[i].kind == ProgramToken::Kind::Name;
}

bool isOneOf(const ProgramLines &program, std::size_t i, std::initializer_list<const char *> words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](const char *word) { return program.is(i, word); });
}

/// The first token of the target that ends at \p i, such as circles of circles[1].v.
std::size_t targetStart(const ProgramLines &program, std::size_t i)
{
    while (i > 0) {
        if (program.is(i, "]")) {
            while (i > 0 && !program.is(i, "["))
                --i;
            --i;
        } else if (i > 1 && program.is(i - 1, ".")) {
            i -= 2;
        } else {
            break;
        }
    }
    return i;
}

/// What the target that ends at \p last is called, or the table of which it is a row; empty if it
/// is not \p ofRows.
QString targetName(const ProgramLines &program, std::size_t last, bool ofRows)
{
    std::size_t at = last;
    if (ofRows != program.is(last, "]"))
        return {};
    while (at > 0 && program.is(at, "]")) {
        while (at > 0 && !program.is(at, "["))
            --at;
        at -= at > 0 ? 1 : 0;
    }
    return isName(program, at) ? program.tokens()[at].text : QString();
}

/// What is assigned at the sign = at \p sign.
void addAssignments(std::vector<ProgramAssignment> &all, const ProgramLines &program,
                    std::size_t sign, bool isInTable, bool ofRows)
{
    std::vector<ProgramAssignment> targets;
    std::size_t at = sign;
    while (at > 0) {
        const std::size_t last = at - 1;
        const std::size_t first = targetStart(program, last);
        if (!isName(program, first) || program.is(first - 1, "for"))
            return;
        targets.push_back({.line = program.tokens()[sign].line,
                           .name = targetName(program, last, ofRows),
                           .isField = isInTable || first != last,
                           .target = first,
                           .last = last});
        if (isInTable || !program.is(first - 1, ","))
            break;
        at = first - 1;
    }
    std::reverse(targets.begin(), targets.end());
    std::vector<std::pair<std::size_t, std::size_t>> values;
    for (std::size_t from = sign + 1;; ++from) {
        const std::size_t to = afterExpression(program, from);
        if (to == from)
            break;
        values.emplace_back(from, to);
        from = to;
        if (!program.is(to, ","))
            break;
    }
    for (std::size_t k = 0; k < targets.size(); ++k) {
        if (values.size() >= targets.size()) {
            targets[k].from = values[k].first;
            targets[k].to = values[k].second;
        }
        if (!targets[k].name.isEmpty())
            all.push_back(targets[k]);
    }
}

} // namespace

std::size_t afterExpression(const ProgramLines &program, std::size_t i)
{
    std::size_t at = i;
    for (;;) {
        while (isOneOf(program, at, {"-", "not", "#"}))
            ++at;
        const std::size_t next =
            isOneOf(program, at, {"nil", "true", "false"}) ? at + 1 : program.afterOperand(at);
        if (next == at)
            return i;
        at = next;
        if (!isOneOf(program, at,
                     {"+", "-", "*", "/", "//", "%", "^", "..", "==", "~=", "<", ">",
                      "<=", ">=", "and", "or"}))
            return at;
        ++at;
    }
}

namespace {

std::vector<ProgramAssignment> allAssignments(const ProgramLines &program, bool ofRows)
{
    std::vector<ProgramAssignment> all;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < program.tokens().size(); ++i) {
        if (isOneOf(program, i, {"{", "(", "["}))
            open.push_back(i);
        else if (isOneOf(program, i, {"}", ")", "]"}) && !open.empty())
            open.pop_back();
        else if (program.is(i, "="))
            addAssignments(all, program, i, !open.empty() && program.is(open.back(), "{"), ofRows);
    }
    return all;
}

} // namespace

std::vector<ProgramAssignment> assignmentsOf(const ProgramLines &program)
{
    return allAssignments(program, false);
}

std::vector<ProgramAssignment> rowAssignmentsOf(const ProgramLines &program)
{
    return allAssignments(program, true);
}

QStringList copiesOf(const ProgramLines &program, const std::vector<ProgramAssignment> &assignments,
                     const QStringList &fields)
{
    QStringList names;
    for (const ProgramAssignment &each : assignments) {
        if (isHandedOn(program, each) && fields.contains(program.tokens()[each.to - 1].text))
            names.append(each.name);
    }
    return names;
}

QStringList valuesIn(const ProgramLines &program, std::size_t from, std::size_t to)
{
    QStringList names;
    for (std::size_t i = from; i < to; ++i) {
        const bool goesOn = isOneOf(program, i + 1, {".", ":", "(", "["});
        if (isName(program, i) && !goesOn && !names.contains(program.tokens()[i].text))
            names.append(program.tokens()[i].text);
    }
    return names;
}

bool isNumber(const ProgramLines &program, const ProgramAssignment &assignment)
{
    std::size_t at = assignment.from;
    while (at < assignment.to && program.is(at, "-"))
        ++at;
    return at + 1 == assignment.to && program.tokens()[at].kind == ProgramToken::Kind::Number;
}

bool isHandedOn(const ProgramLines &program, const ProgramAssignment &assignment)
{
    for (std::size_t i = assignment.from; i < assignment.to; ++i) {
        const bool isPart = isName(program, i) || isOneOf(program, i, {".", ",", ")", "[", "]"})
                            || (program.is(i, "(") && program.is(i - 1, "vec"));
        if (isPart)
            continue;
        // What stands at a number is one circle's, so it has to be that one's.
        const auto first =
            program.tokens().begin() + static_cast<std::ptrdiff_t>(assignment.target);
        const auto end = program.tokens().begin() + static_cast<std::ptrdiff_t>(assignment.last);
        const bool isOfSame = std::any_of(first, end, [&](const ProgramToken &token) {
            return token.text.endsWith(program.tokens()[i].text);
        });
        if (!program.is(i - 1, "[") || !isOfSame)
            return false;
    }
    return assignment.from < assignment.to;
}

} // namespace cradle
