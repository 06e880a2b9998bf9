// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/hit_kinds.h"

#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <cmath>
#include <limits>

namespace cradle {

namespace {

/// Whether what one of two equal circles gains the other loses.
bool areOpposite(const PairHit &hit)
{
    return length(hit.push1() + hit.push2()) < 5e-3 * (1.0 + length(hit.push1()));
}

} // namespace

std::ptrdiff_t rightOf(const std::vector<JudgedMeeting> &hits)
{
    return std::count_if(hits.begin(), hits.end(),
                         [](const JudgedMeeting &one) { return one.isRight; });
}

bool HitKinds::areOfSide() const
{
    const auto division = divisionOf(kinds());
    return division && division->kind == MeetingDivision::Kind::Side;
}

/// By how much two answers to \p hit differ, of how fast they came.
static double differenceOf(const PairHit &hit, const PairVelocities &a, const PairVelocities &b)
{
    return std::max({std::abs(a.along1 - b.along1), std::abs(a.across1 - b.across1),
                     std::abs(a.along2 - b.along2), std::abs(a.across2 - b.across2)})
           / std::abs(hit.meeting.closing());
}

static constexpr double answerBlur = 3e-3; // the line of centres turns a little in a step

bool isSameAnswerTo(const PairHit &hit, const PairVelocities &a, const PairVelocities &b)
{
    return differenceOf(hit, a, b) < answerBlur;
}

/// What divides \p hits; nothing where those that count as wrong go over into those that count as
/// right: how exact we are then divides them.
std::optional<MeetingDivision> HitKinds::divisionOf(const Kinds &hits) const
{
    double right = 0.0;
    double wrong = std::numeric_limits<double>::infinity();
    for (const JudgedMeeting &one : hits) {
        const PairHit &hit = *one.hit;
        const double off =
            differenceOf(hit, hit.leftParts(), rightFor(hit.cameParts(), goodOf(hit)));
        if (one.isRight)
            right = std::max(right, off);
        else
            wrong = std::min(wrong, off);
    }
    const bool isGradual = right > 0.5 * answerBlur && wrong < 2.0 * answerBlur;
    return isGradual ? std::nullopt : divisionBy(hits);
}

/// The hits of all kinds that can be judged.
HitKinds::Kinds HitKinds::kinds() const
{
    const std::vector<PairHit> &own = m_own.pairAnswers();
    const std::vector<PairHit> &right = m_right.pairAnswers();
    Kinds all;
    for (std::size_t i = 0; own.size() == right.size() && i < own.size(); ++i) {
        if (own[i].isMet() && own[i].isAligned() && right[i].isMet() && right[i].isAligned())
            all.push_back({&own[i], isSameAnswerTo(own[i], own[i].leftParts(),
                                                   rightFor(own[i].cameParts(), right[i]))});
    }
    return all;
}

const PairHit &HitKinds::goodOf(const PairHit &hit) const
{
    const auto at = static_cast<std::size_t>(&hit - m_own.pairAnswers().data());
    return m_right.pairAnswers()[at];
}

bool HitKinds::areEqualsRight() const
{
    const auto hits = comparableHits(m_own.pair().equals, m_right.pair().equals);
    return std::all_of(hits.begin(), hits.end(), [](const EqualHit &one) {
        return isSameAnswer(one.hit.leftParts(), one.right);
    });
}

/// \p hits beside the right answers to them.
std::vector<EqualHit> HitKinds::besideRight(const Kinds &hits) const
{
    std::vector<EqualHit> all;
    for (const JudgedMeeting &one : hits) {
        const PairVelocities in = one.hit->cameParts();
        all.push_back({*one.hit, in, rightFor(in, goodOf(*one.hit))});
    }
    return all;
}

/// Whether a law that was found of equal circles holds for all of \p hits.
bool HitKinds::isLawOf(const Kinds &hits) const
{
    const std::vector<EqualHit> all = besideRight(hits);
    const QString &said = m_said.deviations.front().message;
    for (const int circle : {0, 1}) {
        const QString law = lawOfPart(all, circle);
        if (!law.isEmpty() && said.contains(law))
            return true;
    }
    const auto uneven = unevenLaw(m_own.pair(), m_right.pair());
    if (uneven && said.startsWith(uneven->headline))
        return follows(*uneven, all);
    const auto law = saidLaw();
    return law && follows(*law, all);
}

/// The known answer that was found of equal circles, if it is one.
std::optional<ResponseLaw> HitKinds::saidLaw() const
{
    const std::vector<ResponseLaw> laws = knownResponses();
    const QString &said = m_said.deviations.front().message;
    // Two that are told apart by their reason have one headline.
    const auto at = std::find_if(laws.begin(), laws.end(), [&](const ResponseLaw &law) {
        return said.startsWith(law.headline) && said.contains(law.body);
    });
    return at == laws.end() ? std::nullopt : std::optional(*at);
}

/// Whether what was found is that masses grow with some powers, and all of \p hits are so.
bool HitKinds::areMasses(const Kinds &hits) const
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

/// Whether what was found is that what parts two circles is not shared whole, and it is so in all
/// of \p hits that do not come out right: which of unequal ones, at most by chance, are few.
bool HitKinds::areShares(const Kinds &hits) const
{
    if (m_said.deviations.front().topic != Topic::Shares)
        return false;
    std::ptrdiff_t unequal = 0;
    std::ptrdiff_t right = 0;
    for (const JudgedMeeting &one : hits) {
        if (!one.isRight && !isUnshared(*one.hit))
            return false;
        if (!areAlike(one.hit->meeting)) {
            ++unequal;
            right += one.isRight ? 1 : 0;
        }
    }
    return 5 * right <= unequal;
}

/// Whether what was found is that one circle leaves as it should, and it does in \p hit.
bool HitKinds::isOfOneCircle(const PairHit &hit) const
{
    const LawDeviation &found = m_said.deviations.front();
    if (found.suspect != Suspect::Answer || found.moment.circles.size() != 1)
        return false;
    const bool isFirstWrong = found.moment.circles.front() == 0;
    const PairVelocities good = rightFor(hit.cameParts(), goodOf(hit));
    PairVelocities seen = hit.leftParts();
    (isFirstWrong ? seen.along1 : seen.along2) = isFirstWrong ? good.along1 : good.along2;
    (isFirstWrong ? seen.across1 : seen.across2) = isFirstWrong ? good.across1 : good.across2;
    return isSameAnswerTo(hit, seen, good);
}

/// Whether what was found of one push, its size or its direction, is so in \p hit.
bool HitKinds::isOfPush(const PairHit &hit) const
{
    const PairVelocities good = rightFor(hit.cameParts(), goodOf(hit));
    PairVelocities seen = hit.leftParts();
    seen.along1 = good.along1;
    seen.along2 = good.along2;
    const bool isAlong = isSameAnswerTo(hit, seen, good);
    return areOpposite(hit) && isAlong == (m_said.deviations.front().topic != Topic::Direction);
}

/// Whether what was found is that parts across are changed, and they alone are in \p hit.
bool HitKinds::isOfAcross(const PairHit &hit) const
{
    if (m_said.deviations.front().topic != Topic::Across)
        return false;
    const PairVelocities good = rightFor(hit.cameParts(), goodOf(hit));
    PairVelocities seen = hit.leftParts();
    seen.across1 = good.across1;
    seen.across2 = good.across2;
    return isSameAnswerTo(hit, seen, good);
}

/// Whether what was found, which is no law of all \p hits of equal circles, is so in most of them.
bool HitKinds::isOfMost(const Kinds &hits) const
{
    const LawDeviation &found = m_said.deviations.front();
    const auto isSo = [&](const JudgedMeeting &one) {
        const PairHit &hit = *one.hit;
        return !one.isRight
               && (found.topic == Topic::Momentum     ? !areOpposite(hit)
                   : found.moment.circles.size() == 1 ? isOfOneCircle(hit)
                                                      : isOfPush(hit) || isOfAcross(hit));
    };
    return 2 * std::count_if(hits.begin(), hits.end(), isSo) > std::ssize(hits);
}

/// A known answer that all of \p hits follow, and those of equal circles.
std::optional<ResponseLaw> HitKinds::lawOf(const Kinds &hits) const
{
    const std::vector<EqualHit> all = besideRight(hits);
    const std::vector<EqualHit> equals = comparableHits(m_own.pair().equals, m_right.pair().equals);
    for (const ResponseLaw &law : knownResponses()) {
        if (follows(law, all) && follows(law, equals))
            return law;
    }
    return std::nullopt;
}

} // namespace cradle
