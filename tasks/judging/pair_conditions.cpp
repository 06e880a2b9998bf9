// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/hit_kinds.h"
#include "tasks/judging/response_law_words.h"
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
        // One push would count as several hits.
        if (spreadDeviation(m_own.pair(), m_right.pair()) || judgePair(aspect))
            return std::move(m_said);
        if (aspect == Aspect::Response) {
            m_said.deviations = HitKinds(*this).judge(std::move(m_said.deviations));
            if (m_said.deviations.empty()) {
                if (auto stepped = steppedDeviation(m_own.pair(), m_right.pair(), true))
                    m_said.deviations.push_back(std::move(*stepped));
            }
            addSurroundings();
        } else if (m_said.deviations.empty()) {
            if (auto moments = momentsDeviation(m_own.pairChases()))
                m_said.deviations.push_back(std::move(*moments));
        }
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
               || ((kind == Condition::Kind::NotFirst || kind == Condition::Kind::First)
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

    /// \return whether something is said
    bool judgePair(Aspect aspect)
    {
        const auto &own = m_own.pairAgain();
        const auto &right = m_right.pairAgain();
        // Those that are slower or elsewhere need not have come so near then.
        if (aspect == Aspect::Contact && !own.empty() && own.front().hit.isMet()
            && !own.front().hit.fits(own.front().hit.meeting.sum()))
            return false;
        Series<PairOccasion> series;
        for (std::size_t i = 0; own.size() == right.size() && i < own.size(); ++i) {
            const PairHit &hit = own[i].hit;
            const PairHit &good = right[i].hit;
            if (!good.isMet() || hit.stopped)
                continue;
            const bool isAnswer = hit.isMet() && !isTooEarly(hit);
            if (aspect == Aspect::Contact)
                series.add(own[i], right[i], isAnswer);
            else if (isAnswer && hit.isAligned() && good.isAligned())
                series.add(own[i], right[i],
                           isSameAnswerTo(hit, hit.leftParts(), good.leftParts()));
        }
        const bool isKeptSaid =
            std::any_of(m_said.deviations.begin(), m_said.deviations.end(),
                        [](const LawDeviation &one) { return one.suspect == Suspect::Kept; });
        if (auto kept =
                aspect == Aspect::Response && !isKeptSaid ? keptLine(series) : std::nullopt) {
            m_said.deviations.insert(m_said.deviations.begin(), std::move(*kept));
            return true;
        }
        const auto condition = conditionOf(series.when);
        if (!condition || isSaid(condition->kind)
            || (aspect == Aspect::Contact && condition->isOfPlace() && isOfOther())
            || (aspect == Aspect::Response && !condition->isOfHistory()
                && HitKinds(*this).areOfSide()))
            return false;
        const auto &[seen, good] = series.firstWrong();
        const bool isContact = aspect == Aspect::Contact;
        const bool hasLosses = m_ground.pair.restitutions.size() > 1;
        const PairHit &hit = seen->hit;
        const bool isEarly = isContact && hit.answered && isTooEarly(hit);
        QString met =
            (isEarly     ? ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                                 "m/s, and were answered before they touched.")
             : isContact ? ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                             "m/s, and ran into each other.")
             : hasLosses ? ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                             "m/s and e = %4.")
                         : ConditionText::tr("At %1 s of its run they met at %2 m, with %3 "
                                             "m/s."))
                .arg(brief(seen->when.time), brief(seen->when.place),
                     brief(hit.slowness * hit.meeting.closing()));
        if (!isContact && hasLosses)
            met = met.arg(brief(hit.meeting.restitution));
        if (condition->isOfHistory() && seen->when.number > 1)
            met += QLatin1Char(' ')
                   + ConditionText::tr("It was meeting number %1 of that run, %2 s after the one "
                                       "before.")
                         .arg(QString::number(seen->when.number), brief(seen->when.pause));
        say(aspect,
            {!isContact ? ConditionText::tr("Some hits of the two circles come out wrong")
             : isEarly  ? ConditionText::tr("Some meetings are answered before they touch")
             : hit.answered
                 ? ConditionText::tr("Some hits of the two circles are answered too late")
                 : ConditionText::tr("Some hits of the two circles are not answered"),
             isContact ? met : met + QLatin1Char(' ') + describeHit(hit, good->hit),
             triesTold(series.when)
                 + (isContact || !condition->isOfHistory() ? QString() : ownTold())},
            *condition, {0, 1}, {.stage = hit.stage, .step = good->hit.step},
            [](const LawDeviation &found) { return found.suspect != Suspect::Masses; });
        return true;
    }

    /// Where all that come out wrong are pushed along the line of the first hit in their run.
    static std::optional<LawDeviation> keptLine(const Series<PairOccasion> &series)
    {
        const PairHit *first = nullptr;
        const PairHit *wrong = nullptr;
        for (std::size_t i = 0; i < series.all.size(); ++i) {
            const auto &[hit, when] = *series.all[i].own;
            if (when.number == 1 && series.when[i].isRight)
                first = &hit;
            if (series.when[i].isRight)
                continue;
            if (!first || !isPushedAlong(hit, first->normal) || isPushedAlong(hit, hit.normal))
                return std::nullopt;
            if (!wrong)
                wrong = &hit;
        }
        return wrong ? std::optional(keptLineDeviation(*first, *wrong)) : std::nullopt;
    }

    static bool isPushedAlong(const PairHit &hit, Vec2 line)
    {
        constexpr double turned = 0.02; // of the line in a step
        return std::abs(cross(normalized(hit.push1()), line)) < turned
               && std::abs(cross(normalized(hit.push2()), line)) < turned;
    }

    /// Where the first hit of the own scene comes out wrong; begins with a blank.
    [[nodiscard]] QString ownTold() const
    {
        const auto &own = m_own.pair().own;
        const auto &right = m_right.pair().own;
        return own && right && own->isMet() && right->isMet() && isOfSameCircles(*own, *right)
                       && !leaveAlike(*own, *right, otherAnswer)
                   ? QLatin1Char(' ')
                         + ConditionText::tr("In your own scene even the first comes out wrong.")
                   : QString();
    }

    /// Whether a velocity changed while the rims were apart, of a program that is not known to
    /// answer so early: that is no answer.
    [[nodiscard]] bool isTooEarly(const PairHit &hit) const
    {
        const PairHit &model = m_own.pairAgain().front().hit;
        return hit.step == 1 && (!model.isMet() || model.fits(model.meeting.sum()));
    }

    /// Where else hits come out right, or were not looked at.
    void addSurroundings()
    {
        std::vector<LawDeviation> &found = m_said.deviations;
        // What is shown in the own scene is about that.
        if (found.empty() || found.front().isConditional || !found.front().moment.stage.pinned)
            return;
        const auto &own = m_own.pair().own;
        const auto &right = m_right.pair().own;
        if (own && right && own->isMet() && right->isMet() && isOfSameCircles(*own, *right)
            && own->fits(own->meeting.sum())
            && leaveAlike(*own, *right, isHeadOn(*own) ? sameNumbers : sameAnswer))
            found.front().message +=
                QLatin1Char(' ')
                + (own->came2 == Vec2{}
                       ? ConditionText::tr("In your own scene, where circle 2 rests, the first hit "
                                           "comes out right.")
                       : ConditionText::tr("In your own scene the first hit comes out right."));
        else if (!m_ground.pair.bothMove)
            found.front().message +=
                QLatin1Char(' ')
                + ConditionText::tr("In all hits that were tried circle 2 was at rest.");
    }

    /// But for the line of centres, which turns in a step of the own scene; by how fast they meet,
    /// for they may fall together.
    static bool leaveAlike(const PairHit &a, const PairHit &b, double blur)
    {
        return length(a.left1 - b.left1) + length(a.left2 - b.left2)
               < blur * length(a.came1 - a.came2);
    }
    static constexpr double sameNumbers = 1e-6; ///< where no line of centres turns
    static constexpr double sameAnswer = 1e-3;  ///< what surely is right
    static constexpr double otherAnswer = 0.04; ///< what surely is wrong

    static bool isOfSameCircles(const PairHit &a, const PairHit &b)
    {
        return a.meeting.radius1 == b.meeting.radius1 && a.meeting.radius2 == b.meeting.radius2
               && a.meeting.density1 == b.meeting.density1
               && a.meeting.density2 == b.meeting.density2
               && a.meeting.restitution == b.meeting.restitution;
    }
};

} // namespace

ConditionedAspect conditionedPair(const ConditionComparison &comparison, Aspect aspect)
{
    return PairConditions(comparison).judge(aspect);
}

} // namespace cradle
