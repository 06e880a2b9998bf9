// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_at_fault.h"

#include "tasks/judging/likeness.h"
#include "tasks/judging/repairs.h"

#include <QHash>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <map>
#include <optional>

namespace cradle {

namespace {

/// Changed programs that pass the first look and are measured.
constexpr int mostMeasured = 7;
constexpr int mostOfALine = 3;
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
    Probe probe(&program, moment.stage, true);
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
        const std::vector<World> theirs = statesOf(query.program, m_moment, m_steps);
        if (isWhole(right) && isWhole(theirs)) {
            m_whole = {right.back().circles, theirs.back().circles};
            const qint64 start = m_moment.step - 1 - settling;
            if (start > settling && goesOn(query.reference, right, start)
                && goesOn(query.program, theirs, start)) {
                m_start = right[static_cast<std::size_t>(start)];
                m_late = {m_whole.wanted, after(query.program, m_moment, m_steps, &*m_start)};
            }
        }
        const double h = query.moment.stage.preset.timestep;
        m_slack = query.moment.isPosition && !query.isHit
                      ? 1e-7 + 0.4 * length(query.moment.stage.preset.gravity) * h * h
                      : 0.2;
    }

    /// The circles that are wrong do what is asked; the others may go on as they did. Several
    /// changes may lead to one program: it is looked at once.
    [[nodiscard]] bool isRight(const QString &program)
    {
        auto seen = m_seen.find(program);
        if (seen == m_seen.end())
            seen = m_seen.insert(program, doesRight(program));
        return *seen;
    }

private:
    [[nodiscard]] bool doesRight(const QString &program) const
    {
        // Who does the same all the way does it from the midst of the way, which is soon seen.
        return (!m_start || isNear(after(program, m_moment, m_steps, &*m_start), m_late, 2.0))
               && isNear(after(program, m_moment, m_steps), m_whole, 1.0);
    }

    /// What there is in the end.
    struct Ends {
        std::vector<Circle> wanted{};
        std::vector<Circle> was{}; ///< of the program itself
    };

    [[nodiscard]] bool isWhole(const std::vector<World> &states) const
    {
        return static_cast<qint64>(states.size()) == m_steps + 1;
    }

    /// Whether a program that begins in the midst of its own run goes on as that did: it keeps
    /// nothing to itself.
    [[nodiscard]] bool goesOn(const QString &program, const std::vector<World> &states,
                              qint64 start) const
    {
        return after(program, m_moment, m_steps, &states[static_cast<std::size_t>(start)])
               == states.back().circles;
    }

    [[nodiscard]] bool isNear(const std::vector<Circle> &made, const Ends &ends,
                              double tolerance) const
    {
        if (made.empty() || made.size() != ends.wanted.size() || made.size() != ends.was.size())
            return false;
        for (std::size_t i = 0; i < made.size(); ++i) {
            const auto &wrong = m_moment.circles;
            const bool isWrong =
                std::find(wrong.begin(), wrong.end(), static_cast<int>(i)) != wrong.end();
            if (!isLike(made[i], ends.wanted[i], tolerance)
                && (isWrong || !isLike(made[i], ends.was[i], tolerance)))
                return false;
        }
        return true;
    }

    [[nodiscard]] bool isLike(const Circle &a, const Circle &b, double tolerance) const
    {
        return isAlike(a.velocity, b.velocity, tolerance * near)
               && length(a.position - b.position) < tolerance * m_slack;
    }

    const Moment &m_moment;
    qint64 m_steps;
    Ends m_whole{};
    std::optional<World> m_start{}; ///< in the midst of the reference's run, if one may begin there
    Ends m_late{};                  ///< of runs that begin there
    double m_slack = 0.0;
    QHash<QString, bool> m_seen{}; ///< of the programs that were looked at
};

/// The lines that only the moment needs, then others that run at it, then those that work out what
/// circles keep, such as masses; of the first those that a teacher would look at before others.
std::vector<int> suspects(const FaultQuery &query)
{
    const QStringList rows = query.program.split(QLatin1Char('\n'));
    std::vector<int> lines;
    const auto add = [&](int line) {
        if (std::find(lines.begin(), lines.end(), line) == lines.end())
            lines.push_back(line);
    };
    static const QRegularExpression comparison(QStringLiteral("[<>]"));
    for (const int line : query.ran.now) {
        if (query.suspect == Suspect::Question && rows[line - 1].contains(comparison))
            add(line);
    }
    if (query.suspect == Suspect::Answer && query.ran.now.contains(query.last))
        add(query.last);
    static const QRegularExpression masses(QStringLiteral("radius|density|mass"));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (query.suspect == Suspect::Masses && rows[line - 1].contains(masses)
            && !rows[line - 1].contains(comparison))
            add(line);
    }
    for (const int line : query.ran.special())
        add(line);
    for (const int line : query.ran.now)
        add(line);
    static const QRegularExpression quantities(
        QStringLiteral("radius|density|mass|restitution|gravity"));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (rows[line - 1].contains(quantities))
            add(line);
    }
    return lines;
}

} // namespace

int lineAtFault(const FaultQuery &query)
{
    Look look(query);
    // What shows nothing proves nothing.
    if (query.ran.now.empty() || look.isRight(query.program))
        return 0;
    int twins = 0;
    int parts = 0;
    int measured = 0;
    std::map<int, int> tries;
    for (const Repair &repair : repairsOf(query.program, suspects(query))) {
        if (measured >= mostMeasured)
            break;
        if (tries[repair.line] >= mostOfALine || !look.isRight(repair.source))
            continue;
        ++measured;
        ++tries[repair.line];
        const Mending mending = query.mending(repair.source);
        if (mending == Mending::All && repair.alone)
            return repair.line;
        if (mending == Mending::All && twins == 0)
            twins = repair.line;
        if (mending == Mending::Part && parts == 0)
            parts = repair.line;
    }
    return twins != 0 ? twins : parts;
}

} // namespace cradle
