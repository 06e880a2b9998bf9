// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_at_fault.h"

#include "tasks/judging/fault_look.h"
#include "tasks/judging/program_statements.h"
#include "tasks/judging/question_lines.h"
#include "tasks/judging/repair_order.h"
#include "tasks/judging/suspect_lines.h"
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
    return isOfQuestion(suspect) || suspect == Suspect::Masses ? 900 : 720;
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

    [[nodiscard]] bool hasTwins() const { return m_twins.has_value(); }
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
    const std::vector<int> all = suspectLines(query);
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
    if (query.aspect == Aspect::Contact)
        addValues(query.suspect, ValueChange::OfScene);
    if (isOfMasses)
        addValues(query.suspect, ValueChange::Replaced);
    else if (query.aspect == Aspect::Response)
        add(valueRepairsOf(sound, all, query.aspect, Suspect::Masses, query.ran.now,
                           ValueChange::Completed));
    // Where it answers, the sign may be what is missing.
    for (Repair &each : changes)
        each.isRoundabout =
            each.isRoundabout && !(query.suspect == Suspect::Answer && each.line == query.last);
    putInOrder(changes, query.program, soundLines(sound, all, query.aspect, query.suspect),
               query.aspect != Aspect::Motion);
    return changes;
}

} // namespace

namespace {

std::optional<Repair> foundRepair(const FaultQuery &query)
{
    Trials trials;
    FaultLook look(query.program, query.reference, query.moment, query.aspect != Aspect::Motion,
                   isOfQuestion(query.suspect), query.isAnyMethod);
    // What shows nothing proves nothing.
    if (query.ran.now.empty() || !look.showsFault())
        return std::nullopt;
    Proof proof(query);
    std::vector<Repair> doubtful;
    std::optional<Repair> twins;
    for (const Repair &repair : changesOf(query)) {
        const bool isWorse = repair.isDoubtful && (twins || proof.hasTwins());
        if (trials.areEnough() || isWorse)
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

/// Where the same change in lines that are alike mends what the same function returns to them: that
/// is worked out wrong there, once. 0 if there is none, or several, or it is known to be right.
int sharedLine(const FaultQuery &query, const Repair &repair)
{
    SoundValues sound(query.program, query.moment);
    const ProgramLines &program = sound.program();
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const auto calls = [&](int line, const QString &name) {
        const auto &row = program.tokensOf(line);
        return std::any_of(row.begin(), row.end(), [&](std::size_t i) {
            return program.tokens()[i].text == name && program.is(i + 1, "(");
        });
    };
    // A density is no function's of a radius.
    const QLatin1String density("density");
    if (repair.source.count(density) > query.program.count(density))
        return 0;
    int found = 0;
    const std::vector<int> twins = program.twinsOf(repair.line);
    for (const ProgramFunction &function : functions) {
        if (function.name.isEmpty() || !calls(repair.line, function.name)
            || std::none_of(twins.begin(), twins.end(),
                            [&](int twin) { return calls(twin, function.name); }))
            continue;
        int returned = 0;
        int count = 0;
        for (int line = function.first; line <= function.last; ++line) {
            const auto &row = program.tokensOf(line);
            if (std::any_of(row.begin(), row.end(),
                            [&](std::size_t i) { return program.is(i, "return"); })) {
                returned = line;
                ++count;
            }
        }
        if (count != 1 || found != 0
            || soundLines(sound, {returned}, query.aspect, query.suspect).contains(returned))
            return 0;
        found = returned;
    }
    return found;
}

} // namespace

std::optional<Repair> repairOf(const FaultQuery &query)
{
    static const QRegularExpression verdict(QStringLiteral("\\bif (true|false) then\\b"));
    auto repair = foundRepair(query);
    if (!repair)
        return repair;
    if (const int line = repair->alone ? 0 : sharedLine(query, *repair)) {
        repair->line = line;
        return repair;
    }
    const QRegularExpressionMatch match =
        verdict.match(repair->source.section(u'\n', repair->line - 1, repair->line - 1));
    // What is right without one of two branches is wrong in that one.
    const ProgramLines program(query.program);
    if (const int line = match.hasMatch() ? avoidedLine(program, repair->line,
                                                        match.captured(1) == QLatin1String("true"))
                                          : 0)
        repair->line = line;
    return repair;
}

} // namespace cradle
