// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/findings.h"

#include "tasks/judging/condition_words.h"
#include "tasks/judging/finding_list.h"
#include "tasks/judging/floor_fall_words.h"
#include "tasks/judging/floor_rest_words.h"
#include "tasks/judging/hidden_aspects.h"
#include "tasks/judging/known_mistakes.h"
#include "tasks/judging/own_meeting_words.h"
#include "tasks/judging/own_wall_words.h"
#include "tasks/judging/program_work.h"
#include "tasks/judging/start_words.h"
#include "tasks/judging/step_deviations.h"
#include "tasks/judging/task_laws.h"
#include "tasks/judging/turned_circles.h"
#include "tasks/judging/unchanged_words.h"
#include "tasks/judging/unread_field.h"
#include "tasks/judging/wall_together_words.h"
#include "tasks/judging/wall_words.h"
#include "tasks/script/script_limits.h"

#include <algorithm>
#include <memory>

namespace cradle {

namespace {

/// Measures, compares and finds words for one submission.
class Judge
{
public:
    Judge(const Task &task, SubmissionRuns &runs, const std::vector<CheckOutcome> &checks,
          bool provesLines)
        : m_task(task)
        , m_runs(runs)
        , m_submission(runs.submission())
        , m_checks(checks)
        , m_provesLines(provesLines)
        , m_ground(task, m_submission.preset)
        , m_known(lawsOf(task))
        , m_own(m_submission.program(), m_ground)
    {
    }

    [[nodiscard]] std::vector<Finding> find()
    {
        const qint64 work = workOfAStep(m_submission.program(), m_ground.own);
        if (m_ground.timesteps.empty() || m_ground.gravities.empty() || work > mostWork)
            return {};
        m_found.emplace(m_task, m_submission, m_deviations,
                        FaultLines(m_task, m_submission, m_deviations, m_own, m_right, m_ground,
                                   m_provesLines && work < mostWorkToProve));
        take(Aspect::Start, m_deviations.of(m_own, Aspect::Start));
        const bool isFlightRight = m_deviations.of(m_own, Aspect::Motion).empty();
        if (const auto unwritten =
                unwrittenVelocity(m_submission.program(), m_ground, isFlightRight)) {
            m_found->addWritten(*unwritten);
            return m_found->take();
        }
        for (const Aspect aspect :
             {Aspect::Motion, Aspect::Walls, Aspect::Contact, Aspect::Response}) {
            if (aspect == Aspect::Walls) {
                giveRoom();
                takeUnchanged();
            }
            if (!m_deviations.isAsked(aspect) || (aspect == Aspect::Motion && isTurned())
                || (aspect == Aspect::Response && m_unchanged)
                || (aspect == Aspect::Walls && hidesWalls(m_motion))
                || (aspect != Aspect::Motion && (m_motion.isOfPlace || hidesHits(m_motion))))
                continue;
            ConditionedAspect said = withConditions(aspect);
            if (const auto fall = isOfNearness(said.deviations) ? floorFall() : std::nullopt)
                said.deviations = {*fall};
            // Others lie on that floor, too.
            if (const auto lost = isOf(said.deviations, "held") ? together() : std::nullopt)
                said.deviations = {*lost};
            take(aspect, said.deviations);
            if (aspect == Aspect::Motion)
                m_motion = std::move(said);
            if (aspect == Aspect::Walls) {
                takeFallAtFloor();
                takeOwnWalls();
                takeStagedWalls();
            }
        }
        if (m_found->has(Aspect::Motion)) {
            const QString unseen = unseenText(m_motion, m_own, m_right, m_ground, m_deviations);
            if (!unseen.isEmpty())
                m_found->tellBehind(Aspect::Motion, unseen);
        }
        takeMissedMeeting();
        takeRestitution();
        return m_found->take();
    }

private:
    /// The e of the own scene, after what else is wrong with the start.
    void takeRestitution()
    {
        // A known mistake tells the whole start.
        const std::vector<Finding> &all = m_found->all();
        if (std::any_of(all.begin(), all.end(), [](const Finding &f) {
                return f.aspect == Aspect::Start && !f.mistake.isEmpty();
            }))
            return;
        if (const auto e = otherRestitution(m_task, m_submission, m_checks))
            takeOfStart(*e);
    }

    /// That there is no hit to be seen, where neither the start nor what comes before hits explains
    /// it.
    void takeMissedMeeting()
    {
        if (m_found->has(Aspect::Start) || m_found->has(Aspect::Motion)
            || m_found->has(Aspect::Walls))
            return;
        if (const auto missed = missedMeeting(m_task, m_runs, m_checks))
            takeOfStart(*missed);
    }

    /// Of the start, behind what is said of it; where that is nothing, a known mistake may fit.
    void takeOfStart(const LawDeviation &deviation)
    {
        if (m_found->all().empty())
            take(Aspect::Start, {deviation});
        else
            m_found->addToStart(deviation);
    }

    /// That walls are right but in the own scene: the radii there, and e where it is asked for.
    void takeOwnWalls()
    {
        if (m_own.walls().judged.empty() || !m_found->all().empty())
            return;
        if (const auto old = ownWallRadius(m_task, m_runs, m_checks))
            return take(Aspect::Walls, {*old});
        if (m_ground.walls.restitutions.size() < 2)
            return;
        if (const auto other = ownWallShare(m_task, m_runs, m_checks))
            take(Aspect::Walls, {*other});
    }

    /// That gravity acts wrongly in the steps of hits at the floor, where walls fail and nothing
    /// else is known of it.
    void takeFallAtFloor()
    {
        if (!m_deviations.isAsked(Aspect::Walls) || !m_found->all().empty())
            return;
        if (const auto fall = floorFall())
            take(Aspect::Walls, {*fall});
    }

    /// What only other circles at walls, long rests or late answers in a corner show, where walls
    /// fail and nothing is known of it.
    void takeStagedWalls()
    {
        const QString *program = m_submission.program();
        if (!m_deviations.isAsked(Aspect::Walls) || !m_found->all().empty() || !program
            || m_task.solution.isEmpty() || m_own.walls().judged.empty())
            return;
        auto found = together();
        if (!found)
            found = restAtFloor(*program, m_task.solution, m_ground);
        if (!found)
            found = lateInCorner(m_own.walls(), m_right.walls(), m_ground);
        if (found)
            take(Aspect::Walls, {*found});
    }

    [[nodiscard]] std::optional<LawDeviation> floorFall() const
    {
        return fallAtFloor(m_submission.program(), m_ground, m_own.flight());
    }

    /// Whether steps near walls are not those of free flight: all else there is seen through them.
    static bool isOfNearness(const std::vector<LawDeviation> &walls) { return isOf(walls, "near"); }
    static bool isOf(const std::vector<LawDeviation> &walls, const char *family)
    {
        return !walls.empty() && walls.front().family == QLatin1String(family);
    }

    [[nodiscard]] std::optional<LawDeviation> together() const
    {
        return m_submission.program() && !m_task.solution.isEmpty()
                   ? wallsTogether(*m_submission.program(), m_task.solution, m_ground)
                   : std::nullopt;
    }

    /// More would take longer than a student waits: some thousand steps are measured, and for the
    /// proof ten times as many.
    static constexpr qint64 mostWork = 40'000;
    static constexpr qint64 mostWorkToProve = 4'000;
    static_assert(mostWorkToProve >= limits::uncountedInstructions);

    /// Whether what is wrong with the motion is only that walls turn circles too soon.
    [[nodiscard]] bool isTurned() const
    {
        return isTurnedAhead(m_own, m_ground, m_deviations)
               || isTurnedFar(m_own, m_ground, m_deviations);
    }

    /// Lets circles meet where no wall turns them, far from where it should.
    void giveRoom()
    {
        constexpr double most = 2.4;    // m from the middle, of the meetings
        constexpr double around = 0.75; // of one, m: two circles, and the way until they meet
        if (!m_ground.pair.asked || !m_deviations.isAsked(Aspect::Walls))
            return;
        const double room = m_own.walls().freeRoom();
        m_ground.pair.room = std::clamp((room - around) / most, 0.0, 1.0);
    }

    /// Whether what looks like a wall that turns both circles may be a hit of the two.
    [[nodiscard]] bool isContactWrong() const
    {
        return m_deviations.isAsked(Aspect::Contact)
               && !m_deviations.of(m_own, Aspect::Contact).empty();
    }

    [[nodiscard]] ConditionedAspect withConditions(Aspect aspect) const
    {
        std::vector<LawDeviation> found = m_deviations.of(m_own, aspect);
        // What the own scene shows, other than the measured ones, is seen through its motion.
        std::erase_if(found, [&](const LawDeviation &each) {
            return (m_unchanged && each.moment.circles == std::vector<int>{*m_unchanged})
                   || (aspect != Aspect::Motion && !each.moment.stage.pinned
                       && isMotionWrong(m_motion))
                   || (each.family == QLatin1String("of two") && isContactWrong());
        });
        // How they fly is not always the same, or not near walls: nor is what comes of it.
        if ((!m_motion.deviations.empty() && m_motion.deviations.front().isConditional)
            || isOfNearness(found))
            return {std::move(found), false};
        const CheckOutcome &failed = *m_deviations.failedOf(aspect);
        return conditioned(aspect, std::move(found), m_own, m_right, m_ground,
                           {.stage = {failed.scene.value_or(m_ground.own), failed.pinned},
                            .step = std::max<qint64>(failed.step, 1)});
    }

    /// What is said of walls and hits at once.
    void takeUnchanged()
    {
        if (!m_deviations.isAsked(Aspect::Walls) || !m_deviations.isAsked(Aspect::Response))
            return;
        const auto unchanged = unchangedVelocity(m_submission.program(), m_ground);
        if (!unchanged || isTurnedByAWall(unchanged->moment.circles.front(), m_own)
            || isPushed(unchanged->moment.circles.front(), m_own))
            return;
        m_unchanged = unchanged->moment.circles.front();
        m_found->add(*unchanged);
    }

    void take(Aspect aspect, const std::vector<LawDeviation> &deviations)
    {
        if (deviations.empty() || !m_deviations.isAsked(aspect))
            return;
        if (m_found->isMended(deviations.front())) {
            const std::vector<Finding> &all = m_found->all();
            if (aspect == Aspect::Response && !all.empty() && all.back().aspect == Aspect::Contact)
                m_found->tellMended(deviations.front());
            return;
        }
        // What a mistake was named for before may show here, too.
        if (m_named && isLike(*m_named, m_own, aspect, m_known->ground()))
            return;
        // Known mistakes are always made.
        const auto found =
            deviations.front().isConditional
                ? std::nullopt
                : knownMistake({m_task, *m_known, m_submission, m_own, aspect, deviations});
        if (found) {
            m_named = &m_known->mistake(*found);
            m_found->add(deviations.front(), m_task.mistakes[*found]);
            return;
        }
        for (const LawDeviation &deviation : deviations) {
            if (!m_found->isMended(deviation))
                m_found->add(deviation);
            else if (&deviation == &deviations[1] && aspect == Aspect::Motion)
                m_found->tellMended(deviation);
        }
    }

    const Task &m_task;
    SubmissionRuns &m_runs;
    const Submission &m_submission;
    const std::vector<CheckOutcome> &m_checks;
    bool m_provesLines;
    Ground m_ground;
    std::shared_ptr<const TaskLaws> m_known; ///< with the step's own preset
    MeasuredLaws m_own;
    const MeasuredLaws &m_right = m_known->right();
    StepDeviations m_deviations{m_task, m_submission, m_checks, m_right, m_ground};
    ConditionedAspect m_motion{};          ///< what was found of it
    std::optional<int> m_unchanged{};      ///< the circle whose velocity nothing changes
    const MeasuredLaws *m_named = nullptr; ///< of the known mistake that was found last
    std::optional<FindingList> m_found{};
};

} // namespace

std::vector<Finding> findingsOf(const Task &task, SubmissionRuns &runs,
                                const std::vector<CheckOutcome> &checks, bool provesLines)
{
    if (task.solution.isEmpty() && !task.forStudents)
        return {};
    return Judge(task, runs, checks, provesLines).find();
}

} // namespace cradle
