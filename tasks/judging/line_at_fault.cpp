// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_at_fault.h"

#include "tasks/judging/asked_values.h"
#include "tasks/judging/fault_look.h"
#include "tasks/judging/program_rows.h"
#include "tasks/judging/program_statements.h"
#include "tasks/judging/repair_order.h"
#include "tasks/judging/value_repairs.h"
#include "tasks/script/work_limit.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <map>
#include <optional>

namespace cradle {

namespace {

constexpr std::size_t mostDoubtful = 3;

/// Changed programs that are looked at, of values and of words: what is asked, and masses, lie
/// behind many lines.
std::size_t mostRepairs(Suspect suspect)
{
    return isOfQuestion(suspect) || suspect == Suspect::Masses ? 800 : 600;
}

/// Whether the line gives numbers as the start of what a stage sets itself: gravity = vec(0, -9.8).
bool isPinnedStart(const QString &row)
{
    static const QRegularExpression start(QStringLiteral(
        "^\\s*((gravity|restitution|[\\w\\[\\]]+\\.(radius|density|position|velocity))\\s*,?\\s*)+"
        "=[-\\d.,\\s()/*]*(vec\\s*\\([-\\d.,\\s()/*]*)*(--.*)?$"));
    return row.contains(start);
}

/// The lines that only the moment needs, then others that run at it, then those that work out what
/// circles keep, such as masses; of the first those that a teacher would look at before others.
std::vector<int> suspects(const FaultQuery &query)
{
    const QStringList rows = query.program.split(QLatin1Char('\n'));
    // What never runs is not to blame.
    const ProgramLines program(query.program);
    const std::set<int> dead = deadLines(program);
    std::vector<int> lines;
    const auto add = [&](int line) {
        if (std::find(lines.begin(), lines.end(), line) == lines.end())
            lines.push_back(line);
    };
    static const QRegularExpression comparison(QStringLiteral("[<>]"));
    for (const int line : query.ran.now) {
        if (isOfQuestion(query.suspect) && rows[line - 1].contains(comparison))
            add(line);
    }
    if (isOfQuestion(query.suspect)) {
        const AskedValues asked(program);
        for (const int line : std::vector<int>(lines)) {
            for (const AskedValue &value : asked.of(line))
                add(value.line);
        }
    }
    if (query.suspect == Suspect::Answer && query.ran.now.contains(query.last))
        add(query.last);
    static const QRegularExpression masses(QStringLiteral("radius|density|mass"));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (query.suspect == Suspect::Masses && rows[line - 1].contains(masses)
            && !rows[line - 1].contains(comparison) && !dead.contains(line))
            add(line);
    }
    for (const int line : query.ran.special())
        add(line);
    for (const int line : query.ran.now)
        add(line);
    static const QRegularExpression quantities(
        QStringLiteral("radius|density|mass|restitution|gravity|square"));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        if (rows[line - 1].contains(quantities) && !dead.contains(line)
            && !(query.moment.stage.pinned && isPinnedStart(rows[line - 1])))
            add(line);
    }
    // What was chosen or made at the start: a method, a circle.
    const std::vector<ProgramFunction> functions = functionsOf(program);
    QStringList chosen{QStringLiteral("true|false|circle[12]")};
    for (const ProgramFunction &each : functions) {
        if (!each.name.isEmpty())
            chosen.append(each.name + QStringLiteral("\\b(?!\\s*\\()"));
    }
    const QRegularExpression choice(
        QStringLiteral("\\b(%1)|[\"']").arg(chosen.join(QLatin1Char('|'))));
    for (int line = 1; line <= static_cast<int>(rows.size()); ++line) {
        const ProgramFunction *function = functionAt(functions, line);
        if (function && function->name != QLatin1String("on_load"))
            continue;
        if (query.aspect == Aspect::Motion && rows[line - 1].contains(choice)
            && !dead.contains(line)
            && !(query.moment.stage.pinned && isPinnedStart(rows[line - 1])))
            add(line);
    }
    // A hit of two is not a matter of the walls.
    if (query.aspect == Aspect::Contact || query.aspect == Aspect::Response)
        std::stable_partition(lines.begin(), lines.end(),
                              [&](int line) { return !asksForWall(rows[line - 1]); });
    // Who only hands a value on seldom gets it wrong.
    std::set<int> copies;
    std::set<int> works;
    for (const ProgramAssignment &each : assignmentsOf(program))
        (isHandedOn(program, each) ? copies : works).insert(each.line);
    std::stable_partition(lines.begin(), lines.end(), [&](int line) {
        return !copies.contains(line) || works.contains(line)
               || (line == query.last && query.suspect == Suspect::Answer);
    });
    return lines;
}

/// Measures changed programs until one is mended.
class Proof
{
public:
    explicit Proof(const FaultQuery &query)
        : m_query(query)
    {
    }

    /// \return whether no better one is to be expected
    bool take(const Repair &repair)
    {
        const Mending mending = m_query.mending(repair.source);
        if (mending == Mending::All && repair.alone)
            m_mended = repair;
        if (mending == Mending::All && !m_twins)
            m_twins = repair;
        if (mending == Mending::Part && !m_part)
            m_part = repair;
        return m_mended.has_value();
    }

    [[nodiscard]] std::optional<Repair> best() const
    {
        return m_mended ? m_mended : m_twins ? m_twins : m_part;
    }

private:
    const FaultQuery &m_query;
    std::optional<Repair> m_mended{};
    std::optional<Repair> m_twins{}; ///< with the same change in lines that are alike
    std::optional<Repair> m_part{};
};

/// What a search has tried so far, and whether that is enough.
class Trials
{
public:
    /// Whether all that is tried any more is known, asked before each change.
    [[nodiscard]] bool areEnough()
    {
        m_afterMended += m_isMended ? 1 : 0;
        return WorkLimit::isPassed() || m_afterMended > mostAfterMended
               || (m_judged >= mostJudged && (m_isMended || m_measured >= mostMeasured));
    }
    /// Whether one more may be put to the checks; it is counted then.
    [[nodiscard]] bool judgesOneMore()
    {
        const bool judges = m_judged < mostJudged;
        m_judged += judges ? 1 : 0;
        return judges;
    }
    /// Whether one more change of a line may be measured; it is counted then.
    [[nodiscard]] bool measuresOneMore(int line)
    {
        const bool measures =
            !m_isMended && m_measured < mostMeasured && ++m_ofLine[line] <= mostOfALine;
        m_measured += measures ? 1 : 0;
        return measures;
    }
    /// \param isMended  whether the change that was measured last took all of the fault away
    void note(bool isMended) { m_isMended = isMended; }
    [[nodiscard]] bool isMended() const { return m_isMended; }

private:
    /// Changed programs that pass the look and are measured: more of those that pass twice.
    static constexpr int mostMeasured = 7;
    static constexpr int mostOfALine = 3;
    /// Those that are put to the checks, which is sooner done.
    static constexpr int mostJudged = 60;
    /// Changes that are looked at once one has taken all of the fault away and left another: one
    /// that leaves nothing is among the next, or there is none.
    static constexpr int mostAfterMended = 200;

    int m_judged = 0;
    int m_measured = 0;
    int m_afterMended = 0;
    bool m_isMended = false;
    std::map<int, int> m_ofLine{};
};

/// What is tried, in the lines first that a teacher would look at first. What lacks something is
/// completed; then a value that is asked for is taken whole before the words of the question are
/// changed, but a mass after its own words were.
std::vector<Repair> changesOf(const FaultQuery &query)
{
    const bool isOfMasses = query.suspect == Suspect::Masses;
    const std::vector<int> all = suspects(query);
    std::vector<int> near;
    std::vector<int> far;
    std::partition_copy(
        all.begin(), all.end(), std::back_inserter(near), std::back_inserter(far), [&](int line) {
            return isOfQuestion(query.suspect) || isOfMasses || !query.ran.before.contains(line);
        });
    const std::vector<int> &valued = query.aspect == Aspect::Response ? near : all;
    std::vector<Repair> changes;
    SoundValues sound(query.program, query.moment);
    const auto add = [&](std::vector<Repair> more) {
        std::move(more.begin(), more.end(), std::back_inserter(changes));
    };
    const auto addValues = [&](Suspect suspect, ValueChange change) {
        add(valueRepairsOf(sound, valued, query.aspect, suspect, query.ran.now, change));
    };
    addValues(query.suspect, ValueChange::Completed);
    if (!isOfMasses)
        addValues(query.suspect, ValueChange::Replaced);
    const std::size_t most = mostRepairs(query.suspect);
    std::vector<Repair> words = repairsOf(query.program, query.reference, near, most);
    const std::size_t room = most - words.size();
    add(std::move(words));
    add(repairsOf(query.program, query.reference, far, room));
    if (isOfMasses)
        addValues(query.suspect, ValueChange::Replaced);
    else if (query.aspect == Aspect::Response)
        add(valueRepairsOf(sound, all, query.aspect, Suspect::Masses, query.ran.now,
                           ValueChange::Completed));
    putInOrder(changes, query.program, soundLines(sound, all, query.aspect, query.suspect));
    return changes;
}

} // namespace

std::optional<Repair> repairOf(const FaultQuery &query)
{
    Trials trials;
    FaultLook look(query.program, query.reference, query.moment, query.aspect != Aspect::Motion,
                   isOfQuestion(query.suspect));
    // What shows nothing proves nothing.
    if (query.ran.now.empty() || !look.showsFault())
        return std::nullopt;
    Proof proof(query);
    std::vector<Repair> doubtful;
    std::optional<Repair> twins;
    for (const Repair &repair : changesOf(query)) {
        if (trials.areEnough())
            break;
        const Sight sight = look.of(repair.source);
        if (sight == Sight::Once && !isOfQuestion(query.suspect) && doubtful.size() < mostDoubtful)
            doubtful.push_back(repair);
        if (sight != Sight::Twice)
            continue;
        // Where nothing else is wrong, that is all.
        if (query.passes && !(twins && !repair.alone) && trials.judgesOneMore()
            && query.passes(repair.source)) {
            if (repair.alone)
                return repair;
            twins = repair;
        }
        if (trials.measuresOneMore(repair.line))
            trials.note(proof.take(repair));
    }
    if (twins)
        return twins;
    for (auto repair = doubtful.begin();
         !trials.isMended() && !WorkLimit::isPassed() && repair != doubtful.end(); ++repair)
        trials.note(proof.take(*repair));
    return proof.best();
}

} // namespace cradle
