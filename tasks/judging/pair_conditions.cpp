// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/condition_comparison.h"
#include "tasks/judging/meeting_division.h"
#include "tasks/judging/response_laws.h"
#include "tasks/judging/response_reading.h"

namespace cradle {

namespace {

/// Judges hits of two circles.
class PairConditions : ConditionComparison
{
public:
    explicit PairConditions(const ConditionComparison &comparison)
        : ConditionComparison(comparison)
    {
    }

    [[nodiscard]] ConditionedAspect judge(Aspect aspect)
    {
        judgePair(aspect);
        return std::move(m_said);
    }

private:
    /// Whether other words tell more: what a program keeps from the first hit has its own.
    [[nodiscard]] bool isSaid(Condition::Kind kind) const
    {
        const auto &found = m_said.deviations;
        // Where nothing divides them, older values than those that are set may count.
        return kind == Condition::Kind::Sometimes
               || (kind == Condition::Kind::First && !found.empty() && m_own.pair().ranThrough)
               || (kind == Condition::Kind::NotFirst
                   && std::any_of(found.begin(), found.end(), [](const LawDeviation &one) {
                          return one.suspect == Suspect::Kept;
                      }));
    }

    /// Whether those that are answered have something else in common than a place: who comes from
    /// one side alone has only some places on the way.
    [[nodiscard]] bool isOfOther() const
    {
        const auto &varied = m_own.pair().varied;
        const auto division = divisionOf(varied, arePushedAlong(m_right.pair()));
        return !varied.empty() && (!division || division->kind != MeetingDivision::Kind::Place);
    }

    void judgePair(Aspect aspect)
    {
        const auto &own = m_own.pairAgain();
        const auto &right = m_right.pairAgain();
        Series<PairOccasion> series;
        for (std::size_t i = 0; own.size() == right.size() && i < own.size(); ++i) {
            const PairHit &hit = own[i].hit;
            const PairHit &good = right[i].hit;
            if (!good.isMet() || hit.stopped)
                continue;
            if (aspect == Aspect::Contact)
                series.add(own[i], right[i], hit.isMet());
            else if (hit.isMet() && hit.isAligned() && good.isAligned())
                series.add(own[i], right[i], isSameAnswer(hit.leftParts(), good.leftParts()));
        }
        const auto condition = conditionOf(series.when);
        if (!condition || isSaid(condition->kind)
            || (aspect == Aspect::Contact && condition->isOfPlace() && isOfOther()))
            return;
        const auto &[seen, good] = series.firstWrong();
        const bool isContact = aspect == Aspect::Contact;
        const bool hasLosses = m_ground.pair.restitutions.size() > 1;
        const PairHit &hit = seen->hit;
        QString met =
            (isContact   ? ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                               "m/s, and ran into each other.")
             : hasLosses ? ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                             "m/s and e = %4.")
                         : ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                             "m/s."))
                .arg(brief(seen->when.time), brief(seen->when.place),
                     brief(hit.slowness * hit.meeting.closing()));
        if (!isContact && hasLosses)
            met = met.arg(brief(hit.meeting.restitution));
        say(aspect,
            {!isContact ? ConditionText::tr("Some hits of the two circles come out wrong")
             : hit.answered
                 ? ConditionText::tr("Some hits of the two circles are answered too late")
                 : ConditionText::tr("Some hits of the two circles are not answered"),
             isContact ? met : met + QLatin1Char(' ') + describeHit(hit, good->hit),
             triesTold(series.when)},
            *condition, {0, 1}, {.stage = hit.stage, .step = good->hit.step},
            [](const LawDeviation &found) { return found.suspect != Suspect::Masses; });
    }
};

} // namespace

ConditionedAspect conditionedPair(const ConditionComparison &comparison, Aspect aspect)
{
    return PairConditions(comparison).judge(aspect);
}

} // namespace cradle
