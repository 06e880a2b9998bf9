// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/push_origin.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Of what is wrong with a velocity, across the line of centres; where two touch is known to some
/// degrees.
constexpr double acrossShare = 0.15;

/// Of what is more than a difference of two: a product, or a quotient.
constexpr int leastWork = 2;

std::optional<World> endOf(const QString &program, const Moment &moment)
{
    Probe probe(&program, moment.stage, true);
    for (qint64 k = 0; k < moment.step; ++k) {
        if (!probe.step())
            return std::nullopt;
    }
    return probe.runs() ? std::optional(probe.world()) : std::nullopt;
}

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
    const ProgramAssignment *found = nullptr;
    for (const ProgramAssignment &each : m_assignments) {
        if (each.name == name && !each.isField && each.line < above && m_ran.now.contains(each.line)
            && each.from < each.to
            && functionAt(m_functions, each.line) == functionAt(m_functions, above)
            && !isHandedOn(m_program, each))
            found = &each;
    }
    return found;
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
        std::size_t from = i + 2;
        int parameter = 0;
        const std::size_t end = m_program.afterGroup(i + 1);
        for (std::size_t at = from; at < end; ++at) {
            if (m_program.is(at, "(") || m_program.is(at, "[")) {
                at = m_program.afterGroup(at) - 1;
            } else if (m_program.is(at, ",") || at + 1 == end) {
                if (parameter < function->parameters.size()
                    && names.contains(function->parameters[parameter])) {
                    given += valuesIn(m_program, from, at);
                    work = std::max(work, workIn(from, at));
                }
                from = at + 1;
                ++parameter;
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

bool PushOrigin::isInverse(const ProgramAssignment *each) const
{
    return each && each->from + 1 < each->to && m_program.is(each->from, "1")
           && m_program.is(each->from + 1, "/");
}

bool PushOrigin::isSizeWrong(const QString &program, const QString &reference, const Moment &moment)
{
    const auto theirs = endOf(program, moment);
    const auto right = reference.isEmpty() ? std::nullopt : endOf(reference, moment);
    if (!theirs || !right || right->circles.size() < 2)
        return false;
    const Vec2 between = right->circles[1].position - right->circles[0].position;
    const double away = length(between);
    return away > 0.0 && std::all_of(moment.circles.begin(), moment.circles.end(), [&](int i) {
               const auto at = static_cast<std::size_t>(i);
               const Vec2 off = theirs->circles[at].velocity - right->circles[at].velocity;
               const double across = (off.x * between.y - off.y * between.x) / away;
               return std::abs(across) <= acrossShare * length(off);
           });
}

} // namespace cradle
