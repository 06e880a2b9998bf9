// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/findings.h"

#include "tasks/judging/flight_words.h"
#include "tasks/judging/known_mistakes.h"
#include "tasks/judging/line_at_fault.h"
#include "tasks/judging/line_guess.h"
#include "tasks/judging/measured_laws.h"
#include "tasks/judging/mending.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/start_words.h"
#include "tasks/judging/task_laws.h"
#include "tasks/judging/wall_words.h"

#include <algorithm>
#include <array>

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
            if (isAsked(aspect))
                take(aspect, deviationsOf(m_own, aspect));
        }
        if (m_findings.empty()) {
            if (const auto e = restitutionDeviation(m_task, m_submission, m_checks))
                take(Aspect::Start, {*e});
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
               && ((aspect != Aspect::Contact && aspect != Aspect::Response)
                   || m_ground.pair.asked);
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

    void take(Aspect aspect, const std::vector<LawDeviation> &deviations)
    {
        if (deviations.empty() || !isAsked(aspect))
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
        for (const LawDeviation &deviation : deviations)
            add(deviation, {}, deviation.message);
    }

    void add(const LawDeviation &deviation, const QString &mistake, const QString &message)
    {
        const CheckOutcome *failed = failedOf(deviation.aspect);
        Finding finding{.aspect = deviation.aspect,
                        .mistake = mistake,
                        .message = message,
                        .check = failed ? failed->id : QString()};
        mark(finding, deviation.moment);
        point(finding, deviation);
        m_findings.push_back(finding);
    }

    /// The assignment that last changed what is wrong, and the calls that led there.
    void mark(Finding &finding, const Moment &moment) const
    {
        if (moment.start)
            return markStart(finding, moment);
        if (!m_submission.script || moment.circles.empty())
            return;
        Probe probe(m_submission.program(), moment.stage);
        for (qint64 k = 1; k < moment.step; ++k) {
            if (!probe.step())
                return;
        }
        const auto field =
            moment.isPosition ? Assignment::Field::Position : Assignment::Field::Velocity;
        bool changed = false;
        for (const Assignment &assignment : probe.trace()) {
            const bool isIt =
                assignment.field == field
                && std::find(moment.circles.begin(), moment.circles.end(), assignment.circle)
                       != moment.circles.end();
            if (!isIt || (changed && !assignment.changed))
                continue;
            changed = changed || assignment.changed;
            finding.line = assignment.line;
            finding.calls = assignment.calls;
        }
    }

    /// The assignment that gave a circle or the scene a wrong value before the first step.
    void markStart(Finding &finding, const Moment &moment) const
    {
        if (!m_submission.script)
            return;
        StudentScript script(*m_submission.script,
                             {.quiet = true, .silent = true, .locked = m_task.locked});
        const int circle = moment.circles.empty() ? -1 : moment.circles.front();
        for (const Assignment &assignment : script.traceStart(m_submission.preset)) {
            if (assignment.field != moment.start || assignment.circle != circle)
                continue;
            finding.line = assignment.line;
            finding.calls = assignment.calls;
        }
        if (finding.line == 0 && circle < 0)
            finding.line = hidingLine(*m_submission.script, *moment.start);
    }

    /// A line in which a small change mends this very fault is better than the last that ran.
    void point(Finding &finding, const LawDeviation &deviation) const
    {
        if (!m_submission.script || deviation.moment.start)
            return;
        const RanLines ran = ranLines(*m_submission.script, deviation.moment);
        const int proven = provenLine(deviation, ran, finding.line);
        const int line = proven != 0 ? proven
                                     : guessedLine(*m_submission.script, deviation, ran,
                                                   finding.line, finding.calls);
        if (line == finding.line)
            return;
        finding.line = line;
        finding.calls.clear();
    }

    [[nodiscard]] int provenLine(const LawDeviation &deviation, const RanLines &ran, int last) const
    {
        const Moment &moment = deviation.moment;
        if (!m_provesLines || moment.circles.empty() || m_findings.size() >= mostProven)
            return 0;
        const Aspect aspect = deviation.aspect == Aspect::Course ? Aspect::Walls : deviation.aspect;
        const std::vector<LawDeviation> before = besides(m_own, aspect);
        const auto repair =
            repairOf({*m_submission.script, m_task.solution, moment, ran, deviation.suspect, last,
                      aspect != Aspect::Motion, [&](const QString &program) {
                          const MeasuredLaws laws(&program, m_ground);
                          return seesAsMuch(laws, aspect)
                                     ? mendingOf(deviation, before, besides(laws, aspect))
                                     : Mending::None;
                      }});
        return repair ? repair->line : 0;
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

    const Task &m_task;
    const Submission &m_submission;
    const std::vector<CheckOutcome> &m_checks;
    bool m_provesLines;
    Ground m_ground;
    std::shared_ptr<const TaskLaws> m_known; ///< with the step's own preset
    MeasuredLaws m_own;
    const MeasuredLaws &m_right = m_known->right();
    const MeasuredLaws *m_named = nullptr; ///< of the known mistake that was found last
    std::vector<Finding> m_findings;
};

} // namespace

std::vector<Finding> findingsOf(const Task &task, const Submission &submission,
                                const std::vector<CheckOutcome> &checks, bool provesLines)
{
    if (task.solution.isEmpty())
        return {};
    return Judge(task, submission, checks, provesLines).find();
}

} // namespace cradle
