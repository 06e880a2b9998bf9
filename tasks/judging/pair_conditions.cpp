// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/condition_comparison.h"
#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/meeting_division.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <cmath>

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
        if (judgePair(aspect))
            return std::move(m_said);
        if (aspect == Aspect::Response) {
            judgeKinds();
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

    /// Whether the hits of many kinds are divided by where the other circle is: few tries of a long
    /// run may be divided by their speeds as well.
    [[nodiscard]] bool isOfSide() const
    {
        const auto division = divisionBy(kinds());
        return division && division->kind == MeetingDivision::Kind::Side;
    }

    /// \return whether something is said
    bool judgePair(Aspect aspect)
    {
        const auto &own = m_own.pairAgain();
        const auto &right = m_right.pairAgain();
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
                series.add(own[i], right[i], isSame(hit, hit.leftParts(), good.leftParts()));
        }
        const auto condition = conditionOf(series.when);
        if (!condition || isSaid(condition->kind)
            || (aspect == Aspect::Contact && condition->isOfPlace() && isOfOther())
            || (aspect == Aspect::Response && !condition->isOfHistory() && isOfSide()))
            return false;
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
             triesTold(series.when)
                 + (isContact || !condition->isOfHistory() ? QString() : ownTold())},
            *condition, {0, 1}, {.stage = hit.stage, .step = good->hit.step},
            [](const LawDeviation &found) { return found.suspect != Suspect::Masses; });
        return true;
    }

    /// Where the first hit of the own scene comes out wrong; begins with a blank.
    [[nodiscard]] QString ownTold() const
    {
        const auto &own = m_own.pair().own;
        const auto &right = m_right.pair().own;
        return own && right && own->isMet() && right->isMet() && isOfSameCircles(*own, *right)
                       && !leaveAlike(*own, *right)
                   ? QLatin1Char(' ')
                         + ConditionText::tr("In your own scene the first comes out wrong, too.")
                   : QString();
    }

    /// Whether two answers to \p hit are the same, as seen from how fast they came.
    static bool isSame(const PairHit &hit, const PairVelocities &a, const PairVelocities &b)
    {
        constexpr double blur = 3e-3; // the line of centres turns a little in a step
        const double slack = blur * std::abs(hit.meeting.closing());
        return std::abs(a.along1 - b.along1) < slack && std::abs(a.across1 - b.across1) < slack
               && std::abs(a.along2 - b.along2) < slack && std::abs(a.across2 - b.across2) < slack;
    }

    /// Whether a velocity changed while the rims were apart, of a program that is not known to
    /// answer so early: that is no answer.
    [[nodiscard]] bool isTooEarly(const PairHit &hit) const
    {
        const PairHit &model = m_own.pairAgain().front().hit;
        return hit.step == 1 && (!model.isMet() || model.fits(model.meeting.sum()));
    }

    using Kinds = std::vector<JudgedMeeting>;

    /// The hits of all kinds that can be judged.
    [[nodiscard]] Kinds kinds() const
    {
        const std::vector<PairHit> &own = m_own.pairAnswers();
        const std::vector<PairHit> &right = m_right.pairAnswers();
        Kinds all;
        for (std::size_t i = 0; own.size() == right.size() && i < own.size(); ++i) {
            if (own[i].isMet() && own[i].isAligned() && right[i].isMet() && right[i].isAligned())
                all.push_back({&own[i], isSame(own[i], own[i].leftParts(),
                                               rightFor(own[i].cameParts(), right[i]))});
        }
        return all;
    }

    /// Whether a law that was found of equal circles holds for all of \p hits.
    [[nodiscard]] bool isLawOf(const Kinds &hits) const
    {
        std::vector<PairHit> own;
        std::vector<PairHit> right;
        for (const JudgedMeeting &one : hits) {
            own.push_back(*one.hit);
            right.push_back(goodOf(*one.hit));
        }
        const std::vector<EqualHit> all = comparableHits(own, right);
        const QString &said = m_said.deviations.front().message;
        for (const int circle : {0, 1}) {
            const QString law = lawOfPart(all, circle);
            if (!law.isEmpty() && said.contains(law))
                return true;
        }
        const auto laws = knownResponses();
        return std::any_of(laws.begin(), laws.end(), [&](const ResponseLaw &law) {
            return said.startsWith(law.headline + QLatin1Char('\n')) && follows(law, all);
        });
    }

    /// Whether what was found is that masses grow with some powers, and all of \p hits are so.
    [[nodiscard]] bool areMasses(const Kinds &hits) const
    {
        if (m_said.deviations.front().suspect != Suspect::Masses)
            return false;
        const MassExponents p(m_own.pair());
        return (p.radius || p.density)
               && std::all_of(hits.begin(), hits.end(), [&](const JudgedMeeting &one) {
                      const auto heavy = massRatio(*one.hit);
                      return heavy && std::abs(*heavy / p.ratioOf(one.hit->meeting) - 1.0) < 0.05;
                  });
    }

    static bool areRightOfEquals(const Kinds &hits)
    {
        return std::all_of(hits.begin(), hits.end(), [](const JudgedMeeting &one) {
            return one.isRight || !isEqual(one.hit->meeting);
        });
    }

    /// Whether what was found is that one circle leaves as it should, and it does in all of \p
    /// hits.
    [[nodiscard]] bool isOfOneCircle(const Kinds &hits) const
    {
        const LawDeviation &found = m_said.deviations.front();
        if (found.suspect != Suspect::Answer || found.moment.circles.size() != 1)
            return false;
        const bool isFirstWrong = found.moment.circles.front() == 0;
        return std::all_of(hits.begin(), hits.end(), [&](const JudgedMeeting &one) {
            const PairVelocities good = rightFor(one.hit->cameParts(), goodOf(*one.hit));
            PairVelocities seen = one.hit->leftParts();
            (isFirstWrong ? seen.along1 : seen.along2) = isFirstWrong ? good.along1 : good.along2;
            (isFirstWrong ? seen.across1 : seen.across2) =
                isFirstWrong ? good.across1 : good.across2;
            return isSame(*one.hit, seen, good);
        });
    }

    /// Whether what was found of two sizes is of masses, and all of \p hits follow some masses, but
    /// not those; the headline is then that of no power.
    [[nodiscard]] bool areOtherMasses(const Kinds &hits)
    {
        LawDeviation &found = m_said.deviations.front();
        if (found.suspect != Suspect::Masses || m_ground.pair.densities.isVaried()
            || !std::all_of(hits.begin(), hits.end(), [](const JudgedMeeting &one) {
                   const double closing = std::abs(one.hit->meeting.closing());
                   return massRatio(*one.hit)
                          && std::abs(one.hit->rebound() - one.hit->meeting.restitution) * closing
                                 < 0.01;
               }))
            return false;
        found.message = ConditionText::tr("The masses do not follow the radii as those of balls do")
                        + found.message.mid(found.message.indexOf(QLatin1Char('\n')));
        return true;
    }

    [[nodiscard]] const PairHit &goodOf(const PairHit &hit) const
    {
        const auto at = static_cast<std::size_t>(&hit - m_own.pairAnswers().data());
        return m_right.pairAnswers()[at];
    }

    /// What was found of a few hits, told of no more than it holds for.
    void judgeKinds()
    {
        std::vector<LawDeviation> &found = m_said.deviations;
        if (!found.empty() && found.front().topic == Topic::Restitution)
            return;
        Kinds all = kinds();
        // All of these are first hits: what is wrong with them was not kept.
        const bool isOfMemory =
            !found.empty()
            && (found.front().suspect == Suspect::Kept || found.front().suspect == Suspect::Copy);
        if (isOfMemory && rightOf(all) < std::ssize(all))
            found.clear();
        if (!found.empty()) {
            const double e = m_own.pair().equals.front().meeting.restitution;
            std::erase_if(
                all, [&](const JudgedMeeting &one) { return one.hit->meeting.restitution != e; });
        }
        // What is said of masses holds where they differ.
        const bool isOfMasses = !found.empty() && areEqualsRight();
        Kinds hits = all;
        if (!found.empty())
            std::erase_if(hits, [&](const JudgedMeeting &one) {
                return isEqual(one.hit->meeting) == isOfMasses;
            });
        const auto right = rightOf(hits);
        if (right == std::ssize(hits) || (!found.empty() && (right == 0 || areMasses(hits))))
            return;
        if (isOfMasses && areRightOfEquals(all) && (isOfOneCircle(all) || areOtherMasses(hits))) {
            found.resize(1);
            found.front().message += countOf(hits, std::nullopt);
            return;
        }
        const bool isLaw = !found.empty() && isLawOf(hits);
        const auto division = isLaw ? std::nullopt : divisionBy(all);
        if (!found.empty() && !division && !isOfMasses) {
            LawDeviation &first = found.front();
            if (!isLaw && !first.isOfSome) {
                const qsizetype end = first.message.indexOf(QLatin1Char('\n'));
                first.message = ConditionText::tr("%1 (in some hits)").arg(first.message.left(end))
                                + first.message.mid(end);
            }
            first.message += countOf(hits, std::nullopt);
            return;
        }
        found = {kindsDeviation(all, division)};
    }

    [[nodiscard]] LawDeviation kindsDeviation(const Kinds &all,
                                              const std::optional<MeetingDivision> &division) const
    {
        const auto wrong = std::find_if(all.begin(), all.end(),
                                        [](const JudgedMeeting &one) { return !one.isRight; });
        const PairHit &hit = *wrong->hit;
        LawDeviation said = responseDeviation(
            rightOf(all) == 0 ? ConditionText::tr("No hit that was tried comes out right")
                              : ConditionText::tr("Some hits of the two circles come out wrong"),
            ConditionText::tr("This one came out wrong: %1.")
                    .arg(describeMeeting(hit, m_ground, division))
                + QLatin1Char(' ') + describeHit(hit, goodOf(hit)) + countOf(all, division),
            hit, Suspect::Formula);
        said.isConditional = true;
        if (division && division->kind == MeetingDivision::Kind::Side)
            said.topic = Topic::Direction;
        return said;
    }

    static std::ptrdiff_t rightOf(const Kinds &hits)
    {
        return std::count_if(hits.begin(), hits.end(),
                             [](const JudgedMeeting &one) { return one.isRight; });
    }

    static QString countOf(const Kinds &hits, const std::optional<MeetingDivision> &division)
    {
        const auto right = static_cast<int>(rightOf(hits));
        const QString all = QString::number(hits.size());
        return QLatin1Char(' ')
               + (division
                      ? ConditionText::tr("Of %1 hits tried, %n came out right: %2.", nullptr,
                                          right)
                            .arg(all, division->phrase)
                      : ConditionText::tr("Of %1 hits tried, %n came out right.", nullptr, right)
                            .arg(all));
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
            && leaveAlike(*own, *right))
            found.front().message +=
                QLatin1Char(' ')
                + ConditionText::tr("In your own scene the first hit comes out right.");
        else if (!m_ground.pair.bothMove)
            found.front().message +=
                QLatin1Char(' ')
                + ConditionText::tr("In all hits that were tried circle 2 was at rest.");
    }

    /// But for the line of centres, which turns in a step of the own scene; by how fast they meet,
    /// for they may fall together.
    static bool leaveAlike(const PairHit &a, const PairHit &b)
    {
        return length(a.left1 - b.left1) + length(a.left2 - b.left2)
               < 0.04 * length(a.came1 - a.came2);
    }

    static bool isOfSameCircles(const PairHit &a, const PairHit &b)
    {
        return a.meeting.radius1 == b.meeting.radius1 && a.meeting.radius2 == b.meeting.radius2
               && a.meeting.density1 == b.meeting.density1
               && a.meeting.density2 == b.meeting.density2
               && a.meeting.restitution == b.meeting.restitution;
    }

    static bool isEqual(const Meeting &m)
    {
        return m.radius1 == m.radius2 && m.density1 == m.density2;
    }

    [[nodiscard]] bool areEqualsRight() const
    {
        const auto hits = comparableHits(m_own.pair().equals, m_right.pair().equals);
        return std::all_of(hits.begin(), hits.end(), [](const EqualHit &one) {
            return isSameAnswer(one.hit.leftParts(), one.right);
        });
    }
};

} // namespace

ConditionedAspect conditionedPair(const ConditionComparison &comparison, Aspect aspect)
{
    return PairConditions(comparison).judge(aspect);
}

} // namespace cradle
