// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/value_origin.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// A part that is less wrong than this share of the other is right.
constexpr double noise = 0.02;

} // namespace

ValueOrigin::ValueOrigin(const QString &program, const QString &reference, const Moment &moment,
                         const RanLines &ran, bool isHit)
    : m_source(program)
    , m_reference(reference)
    , m_moment(moment)
    , m_ran(ran)
    , m_isHit(isHit)
    , m_program(program)
    , m_assignments(assignmentsOf(m_program))
    , m_functions(functionsOf(m_program))
{
}

QStringList ValueOrigin::writtenAt(int line) const
{
    const QLatin1String field(m_moment.isPosition ? "position" : "velocity");
    QStringList names;
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line != line || !each.isField || each.name != field)
            continue;
        if (!isHandedOn(m_program, each))
            return {};
        for (std::size_t i = each.from; i < each.to; ++i) {
            // What a circle has is no value of his own.
            if (m_program.is(i, "position") || m_program.is(i, "velocity"))
                return {};
        }
        names += valuesIn(m_program, each.from, each.to);
    }
    return names;
}

bool ValueOrigin::isWriteBack(int line) const
{
    const ProgramFunction *function = functionAt(m_functions, line);
    const QStringList names = writtenAt(line);
    // What a function is given was worked out where it is called.
    return !names.isEmpty() && std::none_of(names.begin(), names.end(), [&](const QString &name) {
        return function && function->parameters.contains(name);
    });
}

bool ValueOrigin::isExchanged(const ProgramAssignment &assignment, const QStringList &names) const
{
    const QStringList values = valuesIn(m_program, assignment.from, assignment.to);
    return m_isHit && !values.isEmpty() && !m_ran.before.contains(assignment.line)
           && std::all_of(values.begin(), values.end(),
                          [&](const QString &value) { return names.contains(value); });
}

int ValueOrigin::of(int line) const
{
    QStringList names = writtenAt(line);
    // Who writes down one circle in one line and the other in the next keeps both.
    for (const int other : m_moment.circles.size() > 1 ? m_ran.now : std::set<int>{})
        names += isWriteBack(other) ? writtenAt(other) : QStringList{};
    const bool isGivenByCall =
        std::any_of(m_assignments.begin(), m_assignments.end(), [&](const ProgramAssignment &each) {
            return names.contains(each.name) && m_ran.now.contains(each.line)
                   && each.from == each.to;
        });
    int last = 0;
    for (const std::vector<int> &lines : originsOf(names, isGivenByCall)) {
        if (lines.empty())
            return 0;
        const std::vector<int> twins = m_program.twinsOf(lines.front());
        for (const int other : lines) {
            const bool goesOn =
                isGivenByCall
                && functionAt(m_functions, other) == functionAt(m_functions, lines.front());
            if (other != lines.front() && !goesOn
                && std::find(twins.begin(), twins.end(), other) == twins.end())
                return 0;
        }
        last = lines.back();
    }
    return last;
}

std::vector<std::vector<int>> ValueOrigin::originsOf(const QStringList &names,
                                                     bool isGivenByCall) const
{
    const auto now = endOf(m_source, m_moment.step);
    const auto before = endOf(m_source, m_moment.step - 1);
    // A variable of that name would hide the count of steps.
    if (!now || !before || m_program.hasName(QStringLiteral("step")))
        return {};
    const std::vector<Wrong> parts = wrongParts(now);
    std::vector<std::vector<int>> found(parts.size());
    std::vector<std::vector<int>> ofOther(parts.size()); // of the coordinate that is not wrong
    for (const ProgramAssignment &each : m_assignments) {
        // What a function returns was worked out in it, under names of its own.
        if ((!isGivenByCall && !names.contains(each.name)) || !m_ran.now.contains(each.line)
            || (isHandedOn(m_program, each) && !isExchanged(each, names)) || each.from == each.to)
            continue;
        const auto other = endOf(withOther(each, m_moment.step), m_moment.step);
        const auto earlier = m_isHit && m_moment.step > 1
                                 ? endOf(withOther(each, m_moment.step - 1), m_moment.step - 1)
                                 : std::nullopt;
        // What a hit gives from one circle to the other changed in the step before only the one.
        const bool isOfEveryStep =
            earlier && std::any_of(parts.begin(), parts.end(), [&](const Wrong &part) {
                return differs({part.circle, true, true}, *before, *earlier);
            });
        for (std::size_t k = 0; other && !isOfEveryStep && k < parts.size(); ++k) {
            if (differs(parts[k], *now, *other))
                found[k].push_back(each.line);
            else if (differs({parts[k].circle, true, true}, *now, *other))
                ofOther[k].push_back(each.line);
        }
    }
    // Who answers a hit with one coordinate alone has the other forgotten there.
    for (std::size_t k = 0; k < parts.size() && m_isHit && parts.size() > 1; ++k) {
        if (found[k].empty())
            found[k] = ofOther[k];
    }
    return found;
}

Vec2 ValueOrigin::valueOf(const World &world, int circle) const
{
    const Circle &body = world.circles[static_cast<std::size_t>(circle)];
    return m_moment.isPosition ? body.position : body.velocity;
}

bool ValueOrigin::differs(const Wrong &part, const World &a, const World &b) const
{
    const Vec2 one = valueOf(a, part.circle);
    const Vec2 other = valueOf(b, part.circle);
    return (part.x && one.x != other.x) || (part.y && one.y != other.y);
}

std::optional<World> ValueOrigin::endOf(const QString &program, qint64 step) const
{
    return worldAfter(program, m_moment.stage, step);
}

std::vector<ValueOrigin::Wrong> ValueOrigin::wrongParts(const std::optional<World> &theirs) const
{
    std::vector<Wrong> parts;
    for (const int circle : m_moment.circles)
        parts.push_back({circle, true, true});
    const auto right = m_reference.isEmpty() ? theirs : endOf(m_reference, m_moment.step);
    if (!right)
        return parts;
    for (Wrong &part : parts) {
        const Vec2 off = valueOf(*theirs, part.circle) - valueOf(*right, part.circle);
        const double most = std::max(std::abs(off.x), std::abs(off.y));
        if (most > 0.0) {
            part.x = std::abs(off.x) > noise * most;
            part.y = std::abs(off.y) > noise * most;
        }
    }
    return parts;
}

QString ValueOrigin::withOther(const ProgramAssignment &assignment, qint64 step) const
{
    const std::vector<ProgramToken> &tokens = m_program.tokens();
    const qsizetype from = tokens[assignment.from].start;
    const qsizetype to = tokens[assignment.to - 1].end();
    const QString value = m_source.mid(from, to - from);
    const QString step0 = QString::number(step - 1);
    const qsizetype start = tokens[assignment.target].start;
    const QString target = m_source.mid(start, tokens[assignment.last].end() - start);
    QString changed = m_source;
    changed.replace(from, to - from,
                    m_program.isNewName(assignment.target)
                            || m_program.is(assignment.target - 1, "{")
                        ? QStringLiteral("(%1) * (step == %2 and 1.03 or 1)").arg(value, step0)
                        : QStringLiteral("step == %2 and %3 or (%1)").arg(value, step0, target));
    return changed;
}

} // namespace cradle
