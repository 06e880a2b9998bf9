// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/fault_lines.h"

#include "tasks/judging/flight_words.h"
#include "tasks/judging/line_at_fault.h"
#include "tasks/judging/line_guess.h"
#include "tasks/judging/mending.h"
#include "tasks/judging/program_rows.h"
#include "tasks/judging/telling_lines.h"
#include "tasks/judging/value_origin.h"
#include "tasks/script/work_limit.h"

#include <algorithm>
#include <optional>

namespace cradle {

namespace {

/// Findings whose line is proven; those behind wait until the first are mended.
constexpr std::size_t mostProven = 2;

/// Of all programs that are tried for one submission: half a second on a machine of 2020. One that
/// goes round a loop many times a step would take several, and is told without a proof instead.
constexpr qint64 mostWorkOfProofs = 30'000'000;

/// Steps before a fault that shows at times: hundreds of programs come to it.
constexpr qint64 mostStepsOfCondition = 600;

/// Steps before a fault for which values are looked at that would be right: dozens of runs.
constexpr qint64 mostStepsOfValues = 100;

Aspect aspectOf(const LawDeviation &deviation)
{
    return deviation.aspect == Aspect::Course ? Aspect::Walls : deviation.aspect;
}

} // namespace

FaultLines::FaultLines(const Task &task, const Submission &submission,
                       const StepDeviations &deviations, const MeasuredLaws &own,
                       const MeasuredLaws &right, const Ground &ground, bool proves)
    : m_task(task)
    , m_submission(submission)
    , m_deviations(deviations)
    , m_own(own)
    , m_right(right)
    , m_ground(ground)
    , m_proves(proves)
    , m_workLeft(mostWorkOfProofs)
{
}

bool FaultLines::isMendedBefore(const LawDeviation &deviation,
                                const std::vector<Finding> &before) const
{
    if (deviation.aspect == Aspect::Start || deviation.isConditional || m_mended.empty())
        return false;
    const Aspect aspect = aspectOf(deviation);
    const std::vector<LawDeviation> all = m_deviations.besides(m_own, aspect);
    return std::any_of(m_mended.begin(), m_mended.end(), [&](const auto &mended) {
        const MeasuredLaws &laws = mended->laws;
        return seesAsMuch(laws, aspect, before)
               && mendingOf(deviation, all, m_deviations.besides(laws, aspect)) == Mending::All;
    });
}

void FaultLines::point(Finding &finding, const LawDeviation &deviation,
                       const std::vector<Finding> &before)
{
    if (!m_submission.script || deviation.moment.start)
        return;
    const RanLines ran = ranLines(*m_submission.script, deviation.moment);
    const ValueOrigin origin(*m_submission.script, m_task.solution, deviation.moment, ran,
                             deviation.aspect != Aspect::Motion);
    std::optional<int> workedOut;
    if (!deviation.moment.circles.empty() && origin.isWriteBack(finding.line))
        workedOut = origin.of(finding.line);
    const int from = workedOut.value_or(0);
    const int proven = provenLine(deviation, ran, from ? from : finding.line, before);
    // Where a copy is at fault, the value itself in its place mends it, too.
    const int mending = proven == 0 ? mendingLine(deviation, ran) : 0;
    const int line = proven != 0 && deviation.suspect != Suspect::Copy ? proven
                     : mending != 0                                    ? mending
                                    : likelyLine(finding, deviation, ran, workedOut);
    if (line == finding.line)
        return;
    finding.line = line;
    finding.calls.clear();
}

MendingValues FaultLines::valuesOf(SoundValues &sound, const LawDeviation &deviation,
                                   const RanLines &ran) const
{
    return {
        sound.program(), m_task.solution, deviation.moment, ran, deviation.aspect, [&](int line) {
            return soundLines(sound, {line}, deviation.aspect, deviation.suspect).contains(line);
        }};
}

int FaultLines::mendingLine(const LawDeviation &deviation, const RanLines &ran)
{
    const Moment &moment = deviation.moment;
    const bool isOfValue = deviation.suspect == Suspect::Answer
                           || deviation.suspect == Suspect::Formula
                           || deviation.suspect == Suspect::Masses;
    if (!m_proves || !isOfValue || deviation.isConditional || moment.circles.empty()
        || m_workLeft <= 0 || moment.step > mostStepsOfValues || deviation.aspect == Aspect::Contact
        || m_task.solution.isEmpty())
        return 0;
    const WorkLimit limit(m_workLeft);
    SoundValues sound(*m_submission.script, moment);
    // What works out a mass stands before what takes it.
    const auto isSound = [&](int line) {
        return soundLines(sound, {line}, deviation.aspect, deviation.suspect).contains(line);
    };
    const bool isTold =
        deviation.suspect == Suspect::Masses
        && tellingLine(deviation, sound.program(), rowsOf(*m_submission.script), ran, 0, isSound)
               != 0;
    const int line = isTold ? 0 : valuesOf(sound, deviation, ran).line();
    m_workLeft = WorkLimit::left();
    return line;
}

bool FaultLines::isOfOne(const LawDeviation &deviation) const
{
    const std::vector<LawDeviation> all = m_deviations.of(m_own, Aspect::Motion);
    return std::all_of(all.begin(), all.end(), [&](const LawDeviation &each) {
        return each.moment.circles == deviation.moment.circles;
    });
}

int FaultLines::likelyLine(const Finding &finding, const LawDeviation &deviation,
                           const RanLines &ran, std::optional<int> workedOut) const
{
    const QString &script = *m_submission.script;
    SoundValues sound(script, deviation.moment);
    std::optional<MendingValues> values;
    if (m_proves && !isOfQuestion(deviation.suspect) && deviation.suspect != Suspect::Masses
        && deviation.moment.step <= mostStepsOfValues)
        values.emplace(valuesOf(sound, deviation, ran));
    const auto isSound = [&](int line) {
        return soundLines(sound, {line}, deviation.aspect, deviation.suspect).contains(line)
               || (values && values->knows(line));
    };
    const auto hit = [&] { return HitAtMoment(script, m_task.solution, deviation.moment); };
    return guessedLine(script, deviation, ran,
                       {finding.line, workedOut, finding.calls, hit, isSound,
                        deviation.aspect != Aspect::Motion || isOfOne(deviation)});
}

int FaultLines::provenLine(const LawDeviation &deviation, const RanLines &ran, int last,
                           const std::vector<Finding> &before)
{
    const Moment &moment = deviation.moment;
    if (!m_proves || m_deviations.isOfChecks() || moment.circles.empty()
        || before.size() >= mostProven || m_workLeft <= 0
        || (deviation.isConditional && moment.step > mostStepsOfCondition))
        return 0;
    const Aspect aspect = aspectOf(deviation);
    const std::vector<LawDeviation> all = m_deviations.besides(m_own, aspect);
    std::unique_ptr<const Mended> tried; // what is said of later findings asks its laws again
    const auto mending = [&](const QString &program) {
        tried = std::make_unique<Mended>(program, m_ground);
        const Mending done =
            seesAsMuch(tried->laws, aspect, before)
                ? mendingOf(deviation, all, m_deviations.besides(tried->laws, aspect))
                : Mending::None;
        return WorkLimit::isPassed() ? Mending::None : done;
    };
    // A second fault is looked for where the first is mended: there it stands alone.
    const QString &own = *m_submission.script;
    const bool isMended =
        !m_mended.empty() && m_mended.back()->program.count(u'\n') == own.count(u'\n');
    const QString &program = isMended ? m_mended.back()->program : own;
    const auto passes = [&](const QString &changed) {
        return m_deviations.passes(changed) && mending(changed) == Mending::All;
    };
    // What is right at times is measured in no scene.
    const auto measured = [&](const QString &changed) {
        return deviation.isConditional ? Mending::None : mending(changed);
    };
    const WorkLimit limit(m_workLeft);
    const bool isAnyMethod = std::any_of(m_ground.flights.begin(), m_ground.flights.end(),
                                         [](const auto &flight) { return flight.isAnyMethod; });
    const auto repair = repairOf({program, m_task.solution, moment, ran, deviation.suspect, last,
                                  aspect, isAnyMethod, passes, measured});
    m_workLeft = WorkLimit::left();
    if (!repair)
        return 0;
    if (!tried || tried->program != repair->source)
        tried = std::make_unique<Mended>(repair->source, m_ground);
    m_mended.push_back(std::move(tried));
    return repair->line;
}

bool FaultLines::seesAsMuch(const MeasuredLaws &laws, Aspect aspect,
                            const std::vector<Finding> &before) const
{
    for (const LawDeviation &flight : flightDeviations(laws.flight(), m_right.flight(), m_ground)) {
        const auto same = [&](const Finding &f) { return f.message == flight.message; };
        if (aspect != Aspect::Motion && std::none_of(before.begin(), before.end(), same))
            return false;
    }
    if (aspect == Aspect::Walls)
        return laws.walls().judged == m_own.walls().judged;
    return aspect == Aspect::Motion || laws.pair().isJudged;
}

} // namespace cradle
