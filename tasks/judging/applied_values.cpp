// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/applied_values.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

/// From one value to the next; more are of a loop.
constexpr int mostValues = 6;

/// What the scene has and what a circle has is given.
bool isGiven(const QString &name)
{
    static const QSet<QString> given{
        QStringLiteral("position"),    QStringLiteral("velocity"), QStringLiteral("radius"),
        QStringLiteral("mass"),        QStringLiteral("density"),  QStringLiteral("x"),
        QStringLiteral("y"),           QStringLiteral("gravity"),  QStringLiteral("square"),
        QStringLiteral("restitution"), QStringLiteral("circle1"),  QStringLiteral("circle2"),
        QStringLiteral("circles"),     QStringLiteral("step"),     QStringLiteral("left"),
        QStringLiteral("right"),       QStringLiteral("bottom"),   QStringLiteral("top"),
        QStringLiteral("half_width"),  QStringLiteral("math"),     QStringLiteral("vec")};
    return given.contains(name);
}

} // namespace

AppliedValues::AppliedValues(const ProgramLines &program, const RanLines &ran,
                             const std::vector<int> &calls, const LawDeviation &deviation,
                             std::function<bool(int)> isSound)
    : m_program(program)
    , m_ran(ran)
    , m_calls(calls)
    , m_aspect(deviation.aspect)
    , m_suspect(deviation.suspect)
    , m_isSound(std::move(isSound))
    , m_assignments(assignmentsOf(program))
    , m_functions(functionsOf(program))
{
}

int AppliedValues::originOf(int line, bool isQuestion) const
{
    int at = line;
    for (int k = 0; k < mostValues; ++k) {
        std::set<int> origins;
        for (const TokenRange &range : appliedAt(at, isQuestion && k == 0))
            origins.merge(originsIn(range, at, 0));
        if (isQuestion && k == 0)
            std::erase_if(origins, [&](int each) { return !givesNumbers(each); });
        origins.erase(at);
        if (origins.empty() && m_aspect == Aspect::Response && !isQuestion)
            origins = functionsAt(at);
        if (origins.size() != 1)
            return at;
        at = *origins.begin();
    }
    return at;
}

/// What the functions return that a line with a velocity or a push calls.
std::set<int> AppliedValues::functionsAt(int line) const
{
    std::set<int> origins;
    for (const std::size_t i : m_program.tokensOf(line)) {
        if (m_program.is(i + 1, "(") && !m_program.is(i - 1, ":"))
            origins.merge(returnsOf(m_program.tokens()[i].text));
    }
    return origins;
}

/// Whether the value is what stands there already and another that is added to it or taken from
/// it, that other alone, or what a function makes: nothing is worked out of several.
bool AppliedValues::isApplied(const TokenRange &range, const ProgramAssignment *target) const
{
    int sums = 0;
    int products = 0;
    QSet<QString> values;
    bool hasTarget = false;
    for (std::size_t i = range.from; i < range.to; ++i) {
        const ProgramToken &token = m_program.tokens()[i];
        if (const std::size_t after = target ? afterTarget(i, *target) : i; after != i) {
            const bool isPart = m_program.is(after, ".");
            i = isPart ? after + 1 : after - 1;
            hasTarget = hasTarget || !isPart;
            continue;
        }
        const bool isOfLibrary =
            m_program.is(i + 1, "(") && !token.is("vec") && returnsOf(token.text).empty()
            && token.kind == ProgramToken::Kind::Name && !token.is("cos") && !token.is("sin");
        if (token.kind == ProgramToken::Kind::Number || isOfLibrary || token.is("^"))
            return false;
        sums += token.is("+") || token.is("-") ? 1 : 0;
        products += token.is("*") || token.is("/") ? 1 : 0;
        if (token.kind != ProgramToken::Kind::Name || m_program.timesteps().contains(token.text)
            || token.is("vec") || token.is("cos") || token.is("sin") || m_program.is(i + 1, "."))
            continue;
        values.insert(token.text);
        if (m_program.is(i + 1, "(")) // what it is given is not worked out here
            i = m_program.afterGroup(i + 1) - 1;
    }
    return sums <= (hasTarget ? 1 : 0) && products < 2 && values.size() == 1;
}

/// The token behind what the assignment gives, where that begins at \p i; else \p i.
std::size_t AppliedValues::afterTarget(std::size_t i, const ProgramAssignment &target) const
{
    const std::size_t length = target.last + 1 - target.target;
    for (std::size_t k = 0; k < length; ++k) {
        if (i + k >= m_program.tokens().size()
            || m_program.tokens()[i + k].text != m_program.tokens()[target.target + k].text)
            return i;
    }
    return i + length;
}

std::vector<TokenRange> AppliedValues::appliedAt(int line, bool isQuestion) const
{
    std::vector<TokenRange> ranges;
    const std::vector<std::size_t> &row = m_program.tokensOf(line);
    if (row.empty())
        return ranges;
    if (!isQuestion) {
        for (const ProgramAssignment &each : m_assignments) {
            if (each.line == line && each.from < each.to
                && (m_suspect == Suspect::Masses || isApplied({each.from, each.to}, &each))) {
                std::size_t from = each.from;
                for (std::size_t i = from; i < each.to; ++i) {
                    if (const std::size_t after = afterTarget(i, each); after != i) {
                        ranges.push_back({from, i});
                        from = after;
                    }
                }
                ranges.push_back({from, each.to});
            } else if (each.line == line && each.from == each.to) // of a call
                ranges.push_back({each.last + 2, row.back() + 1});
        }
    }
    for (const std::size_t i : row) {
        const bool asks = m_program.is(i, "if") || m_program.is(i, "elseif");
        if (isQuestion ? !asks : !m_program.is(i, "return"))
            continue;
        std::size_t end = i + 1;
        while (end <= row.back() && !m_program.is(end, "then") && !m_program.is(end, "end"))
            ++end;
        if (isQuestion || isApplied({i + 1, end}, nullptr))
            ranges.push_back({i + 1, end});
    }
    return ranges;
}

std::set<int> AppliedValues::originsIn(const TokenRange &range, int line, int depth) const
{
    std::set<int> origins;
    for (std::size_t i = range.from; i < range.to; ++i) {
        const ProgramToken &token = m_program.tokens()[i];
        const bool isCall = m_program.is(i + 1, "(");
        const bool isField = i > 0 && (m_program.is(i - 1, ".") || m_program.is(i - 1, ":"));
        const bool isOwner =
            m_program.is(i + 1, ".") && !m_program.is(i + 2, "x") && !m_program.is(i + 2, "y");
        if (token.kind != ProgramToken::Kind::Name || isGiven(token.text) || isOwner
            || m_program.timesteps().contains(token.text))
            continue;
        if (isCall && !m_program.is(i - 1, ":"))
            origins.merge(returnsOf(token.text));
        else if (!isCall)
            origins.merge(originsOf(token.text, isField, line, depth));
    }
    return origins;
}

std::set<int> AppliedValues::returnsOf(const QString &function) const
{
    std::set<int> lines;
    for (const ProgramFunction &each : m_functions) {
        if (each.name != function)
            continue;
        for (int line = each.first; line <= each.last; ++line) {
            const auto &row = m_program.tokensOf(line);
            const bool returns = std::any_of(row.begin(), row.end(), [&](std::size_t i) {
                return m_program.is(i, "return") && !m_program.is(i + 1, "nil")
                       && !m_program.is(i + 1, "{");
            });
            if (returns && m_ran.now.contains(line) && !m_isSound(line))
                lines.insert(line);
        }
    }
    return lines;
}

std::set<int> AppliedValues::originsOf(const QString &name, bool isField, int line, int depth) const
{
    const ProgramFunction *here = functionAt(m_functions, line);
    if (!isField && here && here->parameters.contains(name))
        return originsOfParameter(*here, here->parameters.indexOf(name), depth);
    const ProgramAssignment *found = nullptr;
    for (const ProgramAssignment &each : m_assignments) {
        if (each.name != name || each.isField != isField || each.line == line)
            continue;
        const bool isHere = functionAt(m_functions, each.line) == here && each.line < line
                            && m_ran.now.contains(each.line);
        const bool wasHere = found && functionAt(m_functions, found->line) == here;
        if (isHere || (!wasHere && (isOfStart(m_functions, each.line) || isField)))
            found = &each;
    }
    if (!found)
        return {};
    if (found->from < found->to && isHandedOn(m_program, *found) && depth < mostValues)
        return originsIn({found->from, found->to}, found->line, depth + 1);
    // Tables and what is nothing yet are filled elsewhere.
    const bool isValue = found->from < found->to || isGivenByCall(*found);
    if (!isValue || m_program.is(found->from, "nil") || m_isSound(found->line))
        return {};
    if (isNumber(m_program, *found))
        return m_aspect == Aspect::Motion || isFlag(*found) ? std::set<int>{}
                                                            : std::set<int>{found->line};
    return m_ran.now.contains(found->line) ? std::set<int>{found->line} : std::set<int>{};
}

bool AppliedValues::givesNumbers(int line) const
{
    return std::any_of(m_assignments.begin(), m_assignments.end(),
                       [&](const ProgramAssignment &each) {
                           return each.line == line && isNumber(m_program, each);
                       });
}

/// A value that the program gives again: a count, the state of something.
bool AppliedValues::isFlag(const ProgramAssignment &assignment) const
{
    return std::count_if(m_assignments.begin(), m_assignments.end(),
                         [&](const ProgramAssignment &each) {
                             return each.name == assignment.name
                                    && each.isField == assignment.isField;
                         })
           > 1;
}

bool AppliedValues::isGivenByCall(const ProgramAssignment &assignment) const
{
    return assignment.from == assignment.to && !m_program.is(assignment.last + 2, "{");
}

std::set<int> AppliedValues::originsOfParameter(const ProgramFunction &function, qsizetype index,
                                                int depth) const
{
    std::set<int> origins;
    for (const int line : m_calls) {
        for (const std::size_t i : m_program.tokensOf(line)) {
            if (m_program.tokens()[i].text != function.name || !m_program.is(i + 1, "("))
                continue;
            const std::vector<TokenRange> given = argumentsOf(m_program, i);
            if (index < static_cast<qsizetype>(given.size()) && depth < mostValues)
                origins.merge(originsIn(given[static_cast<std::size_t>(index)], line, depth + 1));
        }
    }
    return origins;
}

} // namespace cradle
