// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/findings.h"

#include "tasks/judging/condition_words.h"
#include "tasks/judging/fault_lines.h"
#include "tasks/judging/floor_fall_words.h"
#include "tasks/judging/known_mistakes.h"
#include "tasks/judging/last_assignment.h"
#include "tasks/judging/own_meeting_words.h"
#include "tasks/judging/own_wall_words.h"
#include "tasks/judging/start_words.h"
#include "tasks/judging/step_deviations.h"
#include "tasks/judging/task_laws.h"
#include "tasks/judging/unchanged_words.h"
#include "tasks/judging/unread_field.h"
#include "tasks/script/script_limits.h"

#include <algorithm>
#include <memory>

namespace cradle {

namespace {

struct JudgeText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

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
        const qint64 work = workOfAStep();
        if (m_ground.timesteps.empty() || m_ground.gravities.empty() || work > mostWork)
            return {};
        m_lines.emplace(m_task, m_submission, m_deviations, m_own, m_right, m_ground,
                        m_provesLines && work < mostWorkToProve);
        take(Aspect::Start, m_deviations.of(m_own, Aspect::Start));
        if (const auto unwritten = unwrittenVelocity(m_submission.program(), m_ground)) {
            add(*unwritten, {}, unwritten->message);
            // Where the place is written the velocity is not.
            markLastAssignment(m_findings.back(), unwritten->moment, m_task, m_submission);
            return std::move(m_findings);
        }
        for (const Aspect aspect :
             {Aspect::Motion, Aspect::Walls, Aspect::Contact, Aspect::Response}) {
            if (aspect == Aspect::Walls) {
                giveRoom();
                takeUnchanged();
            }
            if (!m_deviations.isAsked(aspect)
                || (aspect == Aspect::Motion && (isTurnedAhead() || isTurnedFar()))
                || (aspect == Aspect::Response && m_unchanged)
                || (aspect != Aspect::Motion && (m_motion.isOfPlace || hidesHits())))
                continue;
            ConditionedAspect said = withConditions(aspect);
            take(aspect, said.deviations);
            if (aspect == Aspect::Motion)
                m_motion = std::move(said);
            if (aspect == Aspect::Walls) {
                takeFallAtFloor();
                takeOwnWalls();
            }
        }
        tellUnseen();
        takeMissedMeeting();
        takeRestitution();
        return std::move(m_findings);
    }

private:
    /// That nothing is known of walls or hits yet, behind what is wrong with the motion.
    void tellUnseen()
    {
        const auto at = std::find_if(m_findings.rbegin(), m_findings.rend(),
                                     [](const Finding &f) { return f.aspect == Aspect::Motion; });
        if (at == m_findings.rend())
            return;
        const bool walls = hasUnseenWalls();
        const bool hits = hasUnseenHits();
        if (!walls && !hits)
            return;
        at->message += QStringLiteral("\n\n");
        at->message +=
            walls && hits
                ? JudgeText::tr("Until this is right, no more can be said of walls and hits.")
            : walls ? JudgeText::tr("Until this is right, no more can be said of the walls.")
                    : JudgeText::tr(
                        "Until this is right, no more can be said of the hits of the two circles.");
    }

    /// Whether a failed check asks for walls, and at none is a circle known to come to them.
    [[nodiscard]] bool hasUnseenWalls() const
    {
        return m_deviations.isAsked(Aspect::Walls) && !m_right.walls().judged.empty()
               && (m_motion.isOfPlace || m_own.walls().judged.empty());
    }

    [[nodiscard]] bool hasUnseenHits() const
    {
        const auto isMet = [](const PairHit &hit) { return hit.isMet(); };
        const std::vector<PairHit> &right = m_right.pair().contacts;
        return m_ground.pair.asked && !m_own.pair().isJudged
               && std::any_of(right.begin(), right.end(), isMet);
    }

    /// The e of the own scene, after what else is wrong with the start.
    void takeRestitution()
    {
        const auto isLater = [](const Finding &f) { return f.aspect != Aspect::Start; };
        const auto at = std::find_if(m_findings.begin(), m_findings.end(), isLater);
        // A known mistake tells the whole start.
        if (std::any_of(m_findings.begin(), at,
                        [](const Finding &f) { return !f.mistake.isEmpty(); }))
            return;
        const auto e = otherRestitution(m_task, m_submission, m_checks);
        if (e)
            addToStart(*e);
    }

    /// That there is no hit to be seen, where neither the start nor what comes before hits explains
    /// it.
    void takeMissedMeeting()
    {
        if (std::any_of(m_findings.begin(), m_findings.end(),
                        [](const Finding &f) { return f.aspect < Aspect::Contact; }))
            return;
        if (const auto missed = missedMeeting(m_task, m_runs, m_checks))
            addToStart(*missed);
    }

    /// That walls are right but in the own scene, where e is asked for.
    void takeOwnWalls()
    {
        if (m_ground.walls.restitutions.size() < 2 || m_own.walls().judged.empty()
            || !m_findings.empty())
            return;
        if (const auto other = ownWallShare(m_task, m_runs, m_checks))
            take(Aspect::Walls, {*other});
    }

    /// That gravity acts wrongly in the steps of hits at the floor, where walls fail and nothing
    /// else is known of it.
    void takeFallAtFloor()
    {
        if (!m_deviations.isAsked(Aspect::Walls) || !m_findings.empty())
            return;
        if (const auto fall = fallAtFloor(m_submission.program(), m_ground, m_own.flight()))
            take(Aspect::Walls, {*fall});
    }

    /// Behind what is said of the start, before all else.
    void addToStart(const LawDeviation &deviation)
    {
        if (m_findings.empty())
            return take(Aspect::Start, {deviation});
        const auto isLater = [](const Finding &f) { return f.aspect != Aspect::Start; };
        const auto place = std::find_if(m_findings.begin(), m_findings.end(), isLater);
        const auto at = place - m_findings.begin();
        add(deviation, {}, deviation.message);
        std::rotate(m_findings.begin() + at, m_findings.end() - 1, m_findings.end());
    }

    /// Instructions that an update takes; a program of the lab takes some hundred.
    [[nodiscard]] qint64 workOfAStep() const
    {
        constexpr int steps = 20;
        Probe probe(m_submission.program(), {m_ground.own, false});
        const qint64 before = probe.instructions();
        for (int k = 0; k < steps && probe.step(); ++k) {
        }
        return (probe.instructions() - before) / steps;
    }

    /// More would take longer than a student waits: some thousand steps are measured, and for the
    /// proof ten times as many.
    static constexpr qint64 mostWork = 40'000;
    static constexpr qint64 mostWorkToProve = 4'000;
    static_assert(mostWorkToProve >= limits::uncountedInstructions);

    /// Whether only what looks too far ahead for walls changes the velocities of fast circles far
    /// from them: that is no fault of the motion.
    [[nodiscard]] bool isTurnedAhead() const
    {
        for (std::size_t i = 0; i < m_ground.flights.size(); ++i) {
            const Flight &flight = m_own.flight().at(
                m_ground.gravities.front(), m_ground.timesteps.front(), static_cast<int>(i));
            if (!flight.isKnown || (flight.leap && flight.leap->speed != Flight::Speed::Fast))
                return false;
        }
        if (m_ground.walls.circles.empty() || m_deviations.of(m_own, Aspect::Motion).size() != 1)
            return false;
        const auto walls = m_deviations.of(m_own, Aspect::Walls);
        return m_deviations.failedOf(Aspect::Walls)
               && std::any_of(walls.begin(), walls.end(), [](const LawDeviation &wall) {
                      return wall.family == QLatin1String("ahead");
                  });
    }

    /// Whether the one thing that is wrong with the motion is that a wall turns a circle in the
    /// first step of the own scene, far from where it should: that is no fault of the motion.
    [[nodiscard]] bool isTurnedFar() const
    {
        const auto motion = m_deviations.of(m_own, Aspect::Motion);
        if (m_ground.walls.circles.empty() || motion.size() != 1
            || motion.front().moment.stage.pinned || !m_deviations.failedOf(Aspect::Walls))
            return false;
        const MeasuredFlight::Own &own = m_own.flight().own();
        const std::vector<int> &circles = motion.front().moment.circles;
        return std::all_of(circles.begin(), circles.end(), [&](int circle) {
            const auto i = static_cast<std::size_t>(circle);
            const Circle &c = own.scene.circles[i].body;
            const Vec2 next = c.velocity + own.scene.timestep * own.accelerations[i];
            return std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
                const Vec2 n = outwardNormal(wall);
                return dot(n, c.velocity) * dot(n, next) < 0.0
                       && m_own.walls().turnsFarAt(circle, wall,
                                                   own.scene.halfWidth - dot(n, c.position));
            });
        });
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

    /// Whether hits cannot be seen through what is wrong with the motion.
    [[nodiscard]] bool hidesHits() const
    {
        return std::any_of(m_motion.deviations.begin(), m_motion.deviations.end(),
                           [](const LawDeviation &each) { return each.hidesHits; });
    }

    /// Whether the circles do not fly as asked; another integrator moves them almost alike.
    [[nodiscard]] bool isMotionWrong() const
    {
        return std::any_of(m_motion.deviations.begin(), m_motion.deviations.end(),
                           [](const LawDeviation &each) { return !each.isMethod; });
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
                   || (aspect != Aspect::Motion && !each.moment.stage.pinned && isMotionWrong())
                   || (each.family == QLatin1String("of two") && isContactWrong());
        });
        // How they fly is not always the same: nor is what comes of it.
        if (!m_motion.deviations.empty() && m_motion.deviations.front().isConditional)
            return {std::move(found), false};
        const CheckOutcome &failed = *m_deviations.failedOf(aspect);
        return conditioned(aspect, std::move(found), m_own, m_right, m_ground,
                           {.stage = {failed.scene.value_or(m_ground.own), failed.pinned},
                            .step = std::max<qint64>(failed.step, 1)});
    }

    /// Whether a wall is known that changes the velocity of that circle: the own scene shows one
    /// only.
    [[nodiscard]] bool isTurnedByAWall(int circle) const
    {
        const std::vector<WallHit> &hits = m_own.walls().hits;
        return std::any_of(hits.begin(), hits.end(),
                           [&](const WallHit &hit) { return hit.circle == circle && hit.turned; });
    }

    /// Whether a hit that is thrown changes it.
    [[nodiscard]] bool isPushed(int circle) const
    {
        const auto pushes = [circle](const PairHit &hit) {
            return hit.answered && length(circle == 0 ? hit.push1() : hit.push2()) > 1e-9;
        };
        const MeasuredPair &pair = m_own.pair();
        return circle < 2
               && (std::any_of(pair.contacts.begin(), pair.contacts.end(), pushes)
                   || std::any_of(pair.varied.begin(), pair.varied.end(), pushes));
    }

    /// What is said of walls and hits at once.
    void takeUnchanged()
    {
        if (!m_deviations.isAsked(Aspect::Walls) || !m_deviations.isAsked(Aspect::Response))
            return;
        const auto unchanged = unchangedVelocity(m_submission.program(), m_ground);
        if (!unchanged || isTurnedByAWall(unchanged->moment.circles.front())
            || isPushed(unchanged->moment.circles.front()))
            return;
        m_unchanged = unchanged->moment.circles.front();
        add(*unchanged, {}, unchanged->message);
    }

    void take(Aspect aspect, const std::vector<LawDeviation> &deviations)
    {
        if (deviations.empty() || !m_deviations.isAsked(aspect))
            return;
        if (m_lines->isMendedBefore(deviations.front(), m_findings)) {
            if (aspect == Aspect::Response && !m_findings.empty()
                && m_findings.back().aspect == Aspect::Contact)
                tellMended(deviations.front());
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
            const KnownScript &mistake = m_task.mistakes[*found];
            m_named = &m_known->mistake(*found);
            add(deviations.front(), mistake.name, mistake.message);
            return;
        }
        for (const LawDeviation &deviation : deviations) {
            if (!m_lines->isMendedBefore(deviation, m_findings))
                add(deviation, {}, deviation.message);
            else if (&deviation == &deviations[1] && aspect == Aspect::Motion)
                tellMended(deviation);
        }
    }

    /// With what was told last, which the same change mends.
    void tellMended(const LawDeviation &deviation)
    {
        m_findings.back().message += QLatin1Char(' ')
                                     + JudgeText::tr("The same fault shows in this, too: %1.")
                                           .arg(deviation.message.section(QLatin1Char('\n'), 0, 0));
    }

    /// A field that nothing reads, where no other line is known to be at fault.
    void pointToUnread(Finding &finding) const
    {
        const auto field = finding.line == 0 && m_submission.script
                               ? unreadField(*m_submission.script)
                               : std::nullopt;
        if (!field)
            return;
        finding.line = field->line;
        finding.message += QLatin1Char(' ')
                           + JudgeText::tr("Line %1 sets a field `%2` of your own, which nothing "
                                           "reads: a circle has a `%3`.")
                                 .arg(field->line)
                                 .arg(field->name, field->meant);
    }

    void add(const LawDeviation &deviation, const QString &mistake, const QString &message)
    {
        const CheckOutcome *failed = m_deviations.failedOf(deviation.aspect);
        Finding finding{.aspect = deviation.aspect,
                        .mistake = mistake,
                        .message = message,
                        .check = failed ? failed->id : QString()};
        markLastAssignment(finding, deviation.moment, m_task, m_submission);
        m_lines->point(finding, deviation, m_findings);
        pointToUnread(finding);
        m_findings.push_back(finding);
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
    std::optional<FaultLines> m_lines{};
    ConditionedAspect m_motion{};          ///< what was found of it
    std::optional<int> m_unchanged{};      ///< the circle whose velocity nothing changes
    const MeasuredLaws *m_named = nullptr; ///< of the known mistake that was found last
    std::vector<Finding> m_findings;
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
