// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/findings.h"

#include "tasks/judging/asked_laws.h"
#include "tasks/judging/flight_words.h"
#include "tasks/judging/known_mistakes.h"
#include "tasks/judging/last_assignment.h"
#include "tasks/judging/line_at_fault.h"
#include "tasks/judging/line_guess.h"
#include "tasks/judging/measured_laws.h"
#include "tasks/judging/mending.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/push_origin.h"
#include "tasks/judging/start_words.h"
#include "tasks/judging/task_laws.h"
#include "tasks/judging/value_origin.h"
#include "tasks/judging/wall_words.h"
#include "tasks/script/script_limits.h"

#include <algorithm>
#include <array>
#include <memory>

namespace cradle {

namespace {

/// Whether a failure of a check of that kind can come of that aspect.
bool concerns(const QString &kind, Aspect aspect)
{
    const auto is = [&](std::initializer_list<const char *> names) {
        return std::any_of(names.begin(), names.end(),
                           [&](const char *name) { return kind == QLatin1String(name); });
    };
    switch (aspect) {
    case Aspect::Start:
        return true;
    case Aspect::Motion:
        return kind != QLatin1String("start");
    case Aspect::Walls:
    case Aspect::Course:
        return is({"bounces", "stays_inside", "bounce_heights", "settles", "together", "script",
                   "ends_at", "integrates"});
    case Aspect::Contact:
    case Aspect::Response:
        break;
    }
    return is({"collides", "rebounds", "touches", "conserves", "after_contact", "loses_energy",
               "passes_through", "script", "ends_at"});
}

/// Measures, compares and finds words for one submission.
class Judge
{
public:
    Judge(const Task &task, const Submission &submission, const std::vector<CheckOutcome> &checks,
          bool provesLines)
        : m_task(task)
        , m_submission(submission)
        , m_checks(checks)
        , m_provesLines(provesLines)
        , m_ground(task, submission.preset)
        , m_asked(task.forStudents ? std::optional(askedLaws(task)) : std::nullopt)
        , m_known(lawsOf(task))
        , m_own(submission.program(), m_ground)
    {
    }

    [[nodiscard]] std::vector<Finding> find()
    {
        const qint64 work = workOfAStep();
        if (m_ground.timesteps.empty() || m_ground.gravities.empty() || work > mostWork)
            return {};
        m_provesLines = m_provesLines && work < mostWorkToProve;
        take(Aspect::Start, deviationsOf(m_own, Aspect::Start));
        for (const Aspect aspect :
             {Aspect::Motion, Aspect::Walls, Aspect::Contact, Aspect::Response}) {
            if (isAsked(aspect) && (aspect != Aspect::Motion || !isTurnedAhead()))
                take(aspect, deviationsOf(m_own, aspect));
        }
        if (m_findings.empty() && !m_asked) {
            if (const auto e = restitutionDeviation(m_task, m_submission, m_checks))
                take(Aspect::Start, {*e});
        } else if (const auto e = otherRestitution(m_task, m_submission, m_checks)) {
            add(*e, {}, e->message);
            std::rotate(m_findings.begin(), m_findings.end() - 1, m_findings.end());
        }
        return std::move(m_findings);
    }

private:
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

    /// The failed check in which the aspect shows; null if none asks for it.
    [[nodiscard]] const CheckOutcome *failedOf(Aspect aspect) const
    {
        for (const CheckOutcome &outcome : m_checks) {
            const auto spec =
                std::find_if(m_task.checks.begin(), m_task.checks.end(),
                             [&](const CheckSpec &check) { return check.id == outcome.id; });
            if (!outcome.passed && spec != m_task.checks.end() && concerns(spec->kind, aspect))
                return &outcome;
        }
        return nullptr;
    }
    [[nodiscard]] bool isAsked(Aspect aspect) const
    {
        return failedOf(aspect) && (aspect != Aspect::Walls || !m_ground.walls.circles.empty())
               && ((aspect != Aspect::Contact && aspect != Aspect::Response) || m_ground.pair.asked)
               && isKnown(aspect);
    }

    /// Without a solution, what is right is what the checks themselves tell.
    [[nodiscard]] bool isKnown(Aspect aspect) const
    {
        if (!m_asked)
            return true;
        switch (aspect) {
        case Aspect::Start:
            return true;
        case Aspect::Motion:
            return m_asked->motion;
        case Aspect::Walls:
        case Aspect::Course:
            return m_asked->walls;
        case Aspect::Contact:
        case Aspect::Response:
            break;
        }
        return m_asked->pair;
    }

    /// In what a program goes wrong in one aspect.
    [[nodiscard]] std::vector<LawDeviation> deviationsOf(const MeasuredLaws &laws,
                                                         Aspect aspect) const
    {
        switch (aspect) {
        case Aspect::Start:
            return startDeviations(m_task, m_submission, m_checks);
        case Aspect::Motion:
            return flightDeviations(laws.flight(), m_right.flight(), m_ground);
        case Aspect::Walls:
        case Aspect::Course:
            return wallDeviations(laws.walls(), m_right.walls(), m_ground);
        case Aspect::Contact:
            return contactDeviations(laws.pair(), m_right.pair(), m_ground);
        case Aspect::Response:
            break;
        }
        return responseDeviations(laws.pair(), m_right.pair(), m_ground);
    }

    /// Whether only what looks too far ahead for walls changes the velocities of fast circles far
    /// from them: that is no fault of the motion.
    [[nodiscard]] bool isTurnedAhead() const
    {
        for (std::size_t i = 0; i < m_ground.flights.size(); ++i) {
            const Flight &flight = m_own.flight().at(
                m_ground.gravities.front(), m_ground.timesteps.front(), static_cast<int>(i));
            if (!flight.isKnown || (flight.leap && !flight.leap->isFast))
                return false;
        }
        if (m_ground.walls.circles.empty() || deviationsOf(m_own, Aspect::Motion).size() != 1)
            return false;
        const auto walls = deviationsOf(m_own, Aspect::Walls);
        return failedOf(Aspect::Walls)
               && std::any_of(walls.begin(), walls.end(), [](const LawDeviation &wall) {
                      return wall.family == QLatin1String("ahead");
                  });
    }

    void take(Aspect aspect, const std::vector<LawDeviation> &deviations)
    {
        if (deviations.empty() || !isAsked(aspect) || isMendedBefore(deviations.front()))
            return;
        // What a mistake was named for before may show here, too.
        if (m_named && isLike(*m_named, m_own, aspect, m_known->ground()))
            return;
        const auto found =
            knownMistake({m_task, *m_known, m_submission, m_own, aspect, deviations});
        if (found) {
            const KnownScript &mistake = m_task.mistakes[*found];
            m_named = &m_known->mistake(*found);
            add(deviations.front(), mistake.name, mistake.message);
            return;
        }
        for (const LawDeviation &deviation : deviations) {
            if (!isMendedBefore(deviation))
                add(deviation, {}, deviation.message);
        }
    }

    /// Whether the change that mends what was found before mends this, too: it is the same fault.
    [[nodiscard]] bool isMendedBefore(const LawDeviation &deviation) const
    {
        if (deviation.aspect == Aspect::Start || m_mended.empty())
            return false;
        const Aspect aspect = aspectOf(deviation);
        const std::vector<LawDeviation> before = besides(m_own, aspect);
        return std::any_of(m_mended.begin(), m_mended.end(), [&](const auto &mended) {
            const MeasuredLaws &laws = mended->laws;
            return seesAsMuch(laws, aspect)
                   && mendingOf(deviation, before, besides(laws, aspect)) == Mending::All;
        });
    }

    static Aspect aspectOf(const LawDeviation &deviation)
    {
        return deviation.aspect == Aspect::Course ? Aspect::Walls : deviation.aspect;
    }

    void add(const LawDeviation &deviation, const QString &mistake, const QString &message)
    {
        const CheckOutcome *failed = failedOf(deviation.aspect);
        Finding finding{.aspect = deviation.aspect,
                        .mistake = mistake,
                        .message = message,
                        .check = failed ? failed->id : QString()};
        markLastAssignment(finding, deviation.moment, m_task, m_submission);
        point(finding, deviation);
        m_findings.push_back(finding);
    }

    /// A line in which a small change mends this very fault is better than the last that ran.
    void point(Finding &finding, const LawDeviation &deviation)
    {
        if (!m_submission.script || deviation.moment.start)
            return;
        const RanLines ran = ranLines(*m_submission.script, deviation.moment);
        const ValueOrigin origin(*m_submission.script, m_task.solution, deviation.moment, ran,
                                 deviation.aspect != Aspect::Motion);
        std::optional<int> workedOut;
        if (!deviation.moment.circles.empty() && origin.isWriteBack(finding.line))
            workedOut = origin.of(finding.line);
        const int proven =
            provenLine(deviation, ran, workedOut && *workedOut > 0 ? *workedOut : finding.line);
        const int line = proven != 0
                             ? proven
                             : guessedLine(*m_submission.script, deviation, ran,
                                           {finding.line, workedOut, finding.calls, [&] {
                                                return PushOrigin::isSizeWrong(*m_submission.script,
                                                                               m_task.solution,
                                                                               deviation.moment);
                                            }});
        if (line == finding.line)
            return;
        finding.line = line;
        finding.calls.clear();
    }

    [[nodiscard]] int provenLine(const LawDeviation &deviation, const RanLines &ran, int last)
    {
        const Moment &moment = deviation.moment;
        if (!m_provesLines || m_asked || moment.circles.empty() || m_findings.size() >= mostProven)
            return 0;
        const Aspect aspect = aspectOf(deviation);
        const std::vector<LawDeviation> before = besides(m_own, aspect);
        const auto repair =
            repairOf({*m_submission.script, m_task.solution, moment, ran, deviation.suspect, last,
                      aspect != Aspect::Motion, [&](const QString &program) {
                          const MeasuredLaws laws(&program, m_ground);
                          return seesAsMuch(laws, aspect)
                                     ? mendingOf(deviation, before, besides(laws, aspect))
                                     : Mending::None;
                      }});
        if (!repair)
            return 0;
        m_mended.push_back(std::make_unique<Mended>(repair->source, m_ground));
        return repair->line;
    }

    /// What is said of an aspect, and of that beside it which a change may spoil.
    [[nodiscard]] std::vector<LawDeviation> besides(const MeasuredLaws &laws, Aspect aspect) const
    {
        std::vector<LawDeviation> found = deviationsOf(laws, aspect);
        if (aspect == Aspect::Response || aspect == Aspect::Contact) {
            const Aspect other = aspect == Aspect::Contact ? Aspect::Response : Aspect::Contact;
            for (LawDeviation &deviation : deviationsOf(laws, other))
                found.push_back(std::move(deviation));
        }
        return found;
    }

    /// Whether as much can be told of a changed program: what cannot be measured is not mended.
    [[nodiscard]] bool seesAsMuch(const MeasuredLaws &laws, Aspect aspect) const
    {
        for (const LawDeviation &flight :
             flightDeviations(laws.flight(), m_right.flight(), m_ground)) {
            const auto same = [&](const Finding &f) { return f.message == flight.message; };
            if (aspect != Aspect::Motion
                && std::none_of(m_findings.begin(), m_findings.end(), same))
                return false;
        }
        if (aspect == Aspect::Walls)
            return laws.walls().judged == m_own.walls().judged;
        return aspect == Aspect::Motion || laws.pair().isJudged;
    }

    /// Findings whose line is proven; those behind wait until the first are mended.
    static constexpr std::size_t mostProven = 2;

    /// The student's program with a change that mends a finding.
    struct Mended {
        Mended(QString source, const Ground &ground)
            : program(std::move(source))
            , laws(&program, ground)
        {
        }
        QString program;
        MeasuredLaws laws;
    };

    const Task &m_task;
    const Submission &m_submission;
    const std::vector<CheckOutcome> &m_checks;
    bool m_provesLines;
    Ground m_ground;
    std::optional<AskedLaws> m_asked;        ///< where there is no solution
    std::shared_ptr<const TaskLaws> m_known; ///< with the step's own preset
    MeasuredLaws m_own;
    const MeasuredLaws &m_right = m_known->right();
    const MeasuredLaws *m_named = nullptr; ///< of the known mistake that was found last
    std::vector<Finding> m_findings;
    std::vector<std::unique_ptr<const Mended>> m_mended;
};

} // namespace

std::vector<Finding> findingsOf(const Task &task, const Submission &submission,
                                const std::vector<CheckOutcome> &checks, bool provesLines)
{
    if (task.solution.isEmpty() && !task.forStudents)
        return {};
    return Judge(task, submission, checks, provesLines).find();
}

} // namespace cradle
