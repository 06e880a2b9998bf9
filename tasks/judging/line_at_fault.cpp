// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_at_fault.h"

#include "tasks/judging/likeness.h"
#include "tasks/judging/repairs.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <map>
#include <optional>

namespace cradle {

namespace {

/// Changed programs that pass the first look and are measured.
constexpr int mostMeasured = 6;
/// Steps after the moment, in which an answer that comes a step later has come.
constexpr qint64 later = 2;
/// Of velocities: a step earlier or later gravity has changed a little.
constexpr double near = 0.03;

/// Steps before the moment, in which what a program keeps from one step to the next has settled.
constexpr qint64 settling = 3;

/// The states of a program step by step, the first before any step; they end where it stops.
std::vector<World> statesOf(const QString &program, const Moment &moment, qint64 steps)
{
    Probe probe(&program, moment.stage);
    std::vector<World> states;
    if (!probe.runs())
        return states;
    states.push_back(probe.world());
    while (static_cast<qint64>(states.size()) <= steps && probe.step())
        states.push_back(probe.world());
    return states;
}

/// The circles after so many steps, also of a program that begins in the midst, at \p start;
/// nothing if it stops.
std::vector<Circle> after(const QString &program, const Moment &moment, qint64 steps,
                          const World *start = nullptr)
{
    Probe probe(&program, moment.stage);
    if (start)
        probe.place(*start);
    for (qint64 k = start ? start->step : 0; k < steps; ++k) {
        if (!probe.step())
            return {};
    }
    return probe.runs() ? probe.world().circles : std::vector<Circle>{};
}

/// The first look: whether a program does at the moment what the reference does.
class Look
{
public:
    explicit Look(const FaultQuery &query)
        : m_moment(query.moment)
        , m_steps(query.moment.step + (query.moment.isPosition ? 0 : later))
    {
        const std::vector<World> right = statesOf(query.reference, m_moment, m_steps);
        if (isWhole(right)) {
            m_wanted = right.back().circles;
            const qint64 start = m_moment.step - 1 - settling;
            if (start > settling && goesOn(query.reference, right, start)
                && goesOn(query.program, statesOf(query.program, m_moment, m_steps), start))
                m_start = right[static_cast<std::size_t>(start)];
        }
        const double h = query.moment.stage.preset.timestep;
        m_slack = query.moment.isPosition
                      ? 1e-7 + 0.4 * length(query.moment.stage.preset.gravity) * h * h
                      : 0.2;
    }

    [[nodiscard]] bool isRight(const QString &program) const
    {
        // Who does the same all the way does it from the midst of the way, which is soon seen.
        return (!m_start || isNear(after(program, m_moment, m_steps, &*m_start), 2.0))
               && isNear(after(program, m_moment, m_steps), 1.0);
    }

private:
    [[nodiscard]] bool isWhole(const std::vector<World> &states) const
    {
        return static_cast<qint64>(states.size()) == m_steps + 1;
    }

    /// Whether a program that begins in the midst of its own run goes on as that did: it keeps
    /// nothing to itself.
    [[nodiscard]] bool goesOn(const QString &program, const std::vector<World> &states,
                              qint64 start) const
    {
        return isWhole(states)
               && after(program, m_moment, m_steps, &states[static_cast<std::size_t>(start)])
                      == states.back().circles;
    }

    /// Whether the circles of the moment are where, and as fast as, they should be.
    [[nodiscard]] bool isNear(const std::vector<Circle> &made, double tolerance) const
    {
        return !made.empty() && made.size() == m_wanted.size()
               && std::all_of(m_moment.circles.begin(), m_moment.circles.end(), [&](int i) {
                      const Circle &a = made[static_cast<std::size_t>(i)];
                      const Circle &b = m_wanted[static_cast<std::size_t>(i)];
                      return isAlike(a.velocity, b.velocity, tolerance * near)
                             && length(a.position - b.position) < tolerance * m_slack;
                  });
    }

    const Moment &m_moment;
    qint64 m_steps;
    std::vector<Circle> m_wanted{};
    std::optional<World> m_start{}; ///< in the midst of the reference's run, if one may begin there
    double m_slack = 0.0;
};

/// The lines that run at the moment, and those that work out what circles keep, such as masses.
std::set<int> suspects(const FaultQuery &query)
{
    Probe probe(&query.program, query.moment.stage);
    for (qint64 k = 1; k < query.moment.step; ++k) {
        if (!probe.step())
            return {};
    }
    const std::vector<int> ran = probe.lines();
    std::set<int> lines(ran.begin(), ran.end());
    static const QRegularExpression quantities(
        QStringLiteral("radius|density|mass|restitution|gravity"));
    const QStringList rows = query.program.split(QLatin1Char('\n'));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (rows[line - 1].contains(quantities))
            lines.insert(line);
    }
    return lines;
}

/// Lines that mend, and how often.
class Mended
{
public:
    void note(int line)
    {
        if (m_times[line]++ == 0)
            m_order.push_back(line);
    }
    /// The line that mends most often, of equal ones the first; 0 if there is none.
    [[nodiscard]] int most() const
    {
        const auto at = std::max_element(m_order.begin(), m_order.end(), [&](int a, int b) {
            return m_times.at(a) < m_times.at(b);
        });
        return at == m_order.end() ? 0 : *at;
    }

private:
    std::map<int, int> m_times;
    std::vector<int> m_order;
};

} // namespace

int lineAtFault(const FaultQuery &query)
{
    const Look look(query);
    Mended all;
    Mended twins;
    Mended parts;
    int measured = 0;
    for (const Repair &repair : repairsOf(query.program, suspects(query))) {
        if (measured >= mostMeasured)
            break;
        if (!look.isRight(repair.source))
            continue;
        ++measured;
        const Mending mending = query.mending(repair.source);
        if (mending == Mending::All)
            (repair.alone ? all : twins).note(repair.line);
        else if (mending == Mending::Part)
            parts.note(repair.line);
    }
    for (const Mended *mended : {&all, &twins, &parts}) {
        if (const int line = mended->most())
            return line;
    }
    return 0;
}

} // namespace cradle
