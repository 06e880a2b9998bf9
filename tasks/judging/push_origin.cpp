// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/push_origin.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

/// Of what is more than a difference of two: a product, or a quotient.
constexpr int leastWork = 2;

} // namespace

PushOrigin::PushOrigin(const ProgramLines &program, const RanLines &ran)
    : m_program(program)
    , m_ran(ran)
    , m_assignments(assignmentsOf(program))
    , m_functions(functionsOf(program))
{
}

PushOrigin::Taken PushOrigin::takenAt(int line) const
{
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line != line || !each.isField || each.name != QLatin1String("velocity"))
            continue;
        QStringList names = valuesIn(m_program, each.from, each.to);
        bool isSum = false;
        for (std::size_t i = each.from; i < each.to; ++i)
            isSum = isSum || m_program.is(i, "+") || m_program.is(i, "-");
        // What is not added to the velocity itself takes its place.
        const bool isAdded = names.removeAll(QStringLiteral("velocity")) > 0;
        return isSum ? Taken{names, isAdded} : Taken{};
    }
    return {};
}

const ProgramAssignment *PushOrigin::assignmentOf(const QString &name, int above) const
{
    return lastAbove(above, name, m_program, m_assignments, m_functions,
                     [&](const ProgramAssignment &each) {
                         return m_ran.now.contains(each.line) && each.from < each.to;
                     });
}

int PushOrigin::workIn(std::size_t from, std::size_t to) const
{
    int work = 0;
    for (std::size_t i = from; i < to; ++i) {
        if (m_program.is(i, "*") || m_program.is(i, "/") || m_program.is(i, "^"))
            work += 2;
        else if (m_program.is(i, "+") || m_program.is(i, "-"))
            ++work;
    }
    return work;
}

const ProgramAssignment *PushOrigin::mostWorked(const QStringList &names, int above) const
{
    const ProgramAssignment *best = nullptr;
    for (const QString &name : names) {
        const ProgramAssignment *each = assignmentOf(name, above);
        if (each && (!best || workOf(*each) > workOf(*best)))
            best = each;
    }
    return best;
}

int PushOrigin::lineOf(const ProgramAssignment &push) const
{
    static const QRegularExpression mass(QStringLiteral("mass|^mu?$|^m_|reduced"),
                                         QRegularExpression::CaseInsensitiveOption);
    const QStringList names = valuesIn(m_program, push.from, push.to).filter(mass);
    const ProgramAssignment *one =
        names.size() == 1 ? assignmentOf(names.front(), push.line) : nullptr;
    if (!one)
        return push.line;
    const bool takesMasses =
        std::any_of(m_program.tokens().begin() + static_cast<std::ptrdiff_t>(one->from),
                    m_program.tokens().begin() + static_cast<std::ptrdiff_t>(one->to),
                    [](const ProgramToken &token) { return token.text.contains(mass); });
    return takesMasses ? one->line : push.line;
}

std::optional<int> PushOrigin::ofGiven(int line, const std::vector<int> &calls) const
{
    const ProgramFunction *function = functionAt(m_functions, line);
    const Taken taken = takenAt(line);
    const QStringList names = taken.isAdded ? taken.names : QStringList{};
    QStringList given;
    int work = 0; // in what is handed on
    const bool isGiven = function && std::any_of(names.begin(), names.end(), [&](const auto &n) {
                             return function->parameters.contains(n);
                         });
    if (!isGiven)
        return std::nullopt;
    for (const std::size_t i :
         calls.empty() ? std::vector<std::size_t>{} : m_program.tokensOf(calls.back())) {
        if (m_program.tokens()[i].text != function->name || !m_program.is(i + 1, "("))
            continue;
        const std::vector<TokenRange> arguments = argumentsOf(m_program, i);
        const std::size_t count =
            std::min(arguments.size(), static_cast<std::size_t>(function->parameters.size()));
        for (std::size_t k = 0; k < count; ++k) {
            if (names.contains(function->parameters[static_cast<qsizetype>(k)])) {
                given += valuesIn(m_program, arguments[k].from, arguments[k].to);
                work = std::max(work, workIn(arguments[k].from, arguments[k].to));
            }
        }
    }
    const ProgramAssignment *push = given.isEmpty() ? nullptr : mostWorked(given, calls.back());
    if (!push)
        return 0;
    // Where e stands, it is asked first.
    const bool takesRestitution =
        std::any_of(m_program.tokens().begin() + static_cast<std::ptrdiff_t>(push->from),
                    m_program.tokens().begin() + static_cast<std::ptrdiff_t>(push->to),
                    [](const ProgramToken &token) { return token.is("restitution"); });
    return work > workOf(*push) && !takesRestitution ? calls.back() : lineOf(*push);
}

int PushOrigin::ofAdded(int line) const
{
    const Taken taken = takenAt(line);
    const ProgramAssignment *push = mostWorked(taken.names, line);
    const auto own = std::find_if(m_assignments.begin(), m_assignments.end(),
                                  [&](const ProgramAssignment &each) { return each.line == line; });
    if (!push || own == m_assignments.end())
        return 0;
    // A new velocity less the old, or what is divided by a mass, is added as it should be.
    int sums = 0;
    bool divides = false;
    bool hasNumber = false;
    for (std::size_t i = own->from; i < own->to; ++i) {
        sums += m_program.is(i, "+") || m_program.is(i, "-") ? 1 : 0;
        divides = divides || m_program.is(i, "/");
        hasNumber = hasNumber || m_program.tokens()[i].text.front().isDigit();
    }
    for (const QString &name : taken.names)
        divides = divides || isInverse(assignmentOf(name, line));
    if (taken.isAdded && sums < 2 && !divides)
        return 0;
    // Then only a number in the line, or more work than before it, can be wrong in it.
    const bool isWorkedOut = taken.isAdded && !hasNumber && workOf(*push) >= leastWork;
    return isWorkedOut || workOf(*push) > workOf(*own) ? lineOf(*push) : 0;
}

int PushOrigin::ofShared(int line, bool isSizeWrong) const
{
    const Taken taken = takenAt(line);
    const auto own = std::find_if(m_assignments.begin(), m_assignments.end(),
                                  [&](const ProgramAssignment &each) { return each.line == line; });
    if (!taken.isAdded || taken.names.size() != 1 || own == m_assignments.end()
        || workOf(*own) != 1)
        return 0;
    const bool isShared =
        std::any_of(m_assignments.begin(), m_assignments.end(), [&](const auto &other) {
            return other.line != line && m_ran.now.contains(other.line) && workOf(other) == 1
                   && takenAt(other.line).isAdded && takenAt(other.line).names == taken.names
                   && functionAt(m_functions, other.line) == functionAt(m_functions, line);
        });
    const ProgramAssignment *push = isShared ? assignmentOf(taken.names.front(), line) : nullptr;
    if (!push)
        return 0;
    // What a function works out of its arguments has its size of it, and its direction of them.
    const int returned = isSizeWrong ? returnOf(functionCalled(push->from, push->to)) : 0;
    return returned != 0 ? returned : push->line;
}

int PushOrigin::ofCalled(int line) const
{
    int best = 0;
    int most = 0;
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line != line)
            continue;
        most = std::max(most, workOf(each));
        for (const QString &name : valuesIn(m_program, each.from, each.to)) {
            const ProgramAssignment *value = assignmentOf(name, line);
            const int returned = value ? returnOf(functionCalled(value->from, value->to)) : 0;
            if (returned == 0 || !m_ran.now.contains(returned))
                continue;
            const auto &tokens = m_program.tokensOf(returned);
            const int work = workIn(tokens.front(), tokens.back() + 1);
            if (work > most) {
                most = work;
                best = returned;
            }
        }
    }
    return best;
}

const ProgramFunction *PushOrigin::functionCalled(std::size_t from, std::size_t to) const
{
    if (from + 1 >= to || !m_program.is(from + 1, "(") || m_program.afterGroup(from + 1) != to)
        return nullptr;
    const auto function =
        std::find_if(m_functions.begin(), m_functions.end(), [&](const ProgramFunction &each) {
            return !each.name.isEmpty() && each.name == m_program.tokens()[from].text;
        });
    return function == m_functions.end() ? nullptr : &*function;
}

int PushOrigin::returnOf(const ProgramFunction *function) const
{
    int found = 0;
    for (int at = function ? function->first : 1; function && at <= function->last; ++at) {
        const auto &tokens = m_program.tokensOf(at);
        if (std::none_of(tokens.begin(), tokens.end(),
                         [&](std::size_t i) { return m_program.is(i, "return"); }))
            continue;
        if (found != 0)
            return 0;
        found = at;
    }
    return found;
}

bool PushOrigin::isInverse(const ProgramAssignment *each) const
{
    return each && each->from + 1 < each->to && m_program.is(each->from, "1")
           && m_program.is(each->from + 1, "/");
}

} // namespace cradle
