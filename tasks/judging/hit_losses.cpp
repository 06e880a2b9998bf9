// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/hit_kinds.h"

#include "tasks/judging/rebound_reading.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cradle {

namespace {

bool isOfRestitution(const LawDeviation &one)
{
    return one.topic == Topic::Restitution;
}

/// What a hit has to have that shows what is wrong with e.
struct Shows {
    bool isOfAcross = false;   ///< parts across the line of centres: else nothing can be lost there
    bool isOfMomentum = false; ///< along it: opposite ones are kept whatever both are multiplied by

    /// \param hits  of equal circles, with losses
    explicit Shows(const std::vector<PairHit> &hits)
    {
        constexpr double blur = 5e-3; // the line of centres turns a little in a step
        for (const PairHit &hit : hits) {
            const PairVelocities in = hit.cameParts();
            const PairVelocities out = hit.leftParts();
            if (!hit.isMet())
                continue;
            isOfAcross |=
                std::abs(out.across1 - in.across1) + std::abs(out.across2 - in.across2) > blur;
            isOfMomentum |= std::abs(out.along1 + out.along2 - in.along1 - in.along2) > blur;
        }
    }

    [[nodiscard]] bool is(const Meeting &m) const
    {
        const PairVelocities &v = m.velocities;
        return (!isOfAcross || (v.across1 != 0.0 && v.across2 != 0.0))
               && (!isOfMomentum || std::abs(v.along1 + v.along2) > 0.05 * std::abs(m.closing()));
    }
};

} // namespace

/// Whether the one hit of equal circles with that e does not come out right.
bool HitKinds::isWrongWith(double restitution) const
{
    const std::vector<PairHit> &own = m_own.pair().rebounds;
    const std::vector<PairHit> &right = m_right.pair().rebounds;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].meeting.restitution == restitution)
            return !own[i].isMet()
                   || !isSameAnswerTo(own[i], own[i].leftParts(),
                                      rightFor(own[i].cameParts(), right[i]));
    }
    return false;
}

/// Those of many kinds with an e below the greatest that show what e does.
HitKinds::Kinds HitKinds::withLosses() const
{
    const double elastic = m_own.pair().equals.front().meeting.restitution;
    const Shows shows(m_own.pair().rebounds);
    Kinds all = kinds();
    std::erase_if(all, [&](const JudgedMeeting &one) {
        const Meeting &m = one.hit->meeting;
        return m.restitution == elastic || !shows.is(m);
    });
    return all;
}

/// Says of what e does, which was read from one way of meeting, that it is so in some hits, where
/// others part in another way; or of equal circles, where unequal ones alone do.
void HitKinds::limitRestitution(const Kinds &hits)
{
    std::map<double, Rebound> rebounds; // of equal circles, by e
    bool isOneE = true;                 // for both
    bool isFirst = true;                // e acts on circle 1 alone, or on circle 2
    bool isSecond = true;
    for (const PairHit &hit : m_own.pair().rebounds) {
        const Rebound r = reboundOf(hit);
        isOneE = isOneE && std::abs(r.first - r.second) <= reboundBlur;
        const auto is = [](double a, double b) { return std::abs(a - b) <= reboundBlur; };
        isFirst = isFirst && is(r.first, r.e) && is(r.second, 1.0);
        isSecond = isSecond && is(r.first, 1.0) && is(r.second, r.e);
        rebounds[r.e] = r;
    }
    // Else what comes back hangs on how they come, too.
    if (!isOneE && !isFirst && !isSecond)
        return;
    const auto isOff = [](double a, double b) { return std::abs(a - b) > 2.0 * reboundBlur; };
    const auto isOther = [&](const JudgedMeeting &one) {
        const Rebound &r = rebounds[one.hit->meeting.restitution];
        const PairVelocities in = one.hit->cameParts();
        const PairVelocities out = one.hit->leftParts();
        // One e for both shows whatever the masses are.
        if (isOneE)
            return isOff((out.along2 - out.along1) / (in.along1 - in.along2), r.first);
        const Rebound each = reboundOf(*one.hit, ballRatioOf(one.hit->meeting));
        return isOff(each.first, r.first) || isOff(each.second, r.second);
    };
    const bool isOfEqual = std::none_of(hits.begin(), hits.end(), [&](const JudgedMeeting &one) {
        return areAlike(one.hit->meeting) && isOther(one);
    });
    if (std::none_of(hits.begin(), hits.end(), isOther))
        return;
    for (LawDeviation &one : m_said.deviations) {
        if (isOfRestitution(one))
            limitTo(one, isOfEqual ? ConditionText::tr("%1 (equal circles)")
                                   : ConditionText::tr("%1 (in some hits)"));
    }
}

/// What e does was read from one way of meeting; where hits that come otherwise are right with the
/// same e, it is told of some, and what divides them.
void HitKinds::judgeRestitution()
{
    std::vector<LawDeviation> &found = m_said.deviations;
    const bool isAlone = std::all_of(found.begin(), found.end(), isOfRestitution);
    Kinds all = withLosses();
    std::erase_if(all, [&](const JudgedMeeting &one) {
        const Meeting &m = one.hit->meeting;
        return !isWrongWith(m.restitution) || (!isAlone && !areAlike(m));
    });
    const auto right = rightOf(all);
    if (right == std::ssize(all))
        return;
    if (right == 0)
        return limitRestitution(all);
    std::erase_if(found, isOfRestitution);
    found.push_back(kindsDeviation(all, divisionOf(all)));
}

/// Says of what was found with the greatest e that it is so with that, where hits of the same kind
/// come out right with every other.
void HitKinds::limitToE(bool isOfMasses)
{
    Kinds all = withLosses();
    std::erase_if(
        all, [&](const JudgedMeeting &one) { return areAlike(one.hit->meeting) == isOfMasses; });
    if (all.size() < 2 || rightOf(all) < std::ssize(all))
        return;
    const QString e = brief(m_own.pair().equals.front().meeting.restitution);
    for (LawDeviation &one : m_said.deviations) {
        if (!one.isOfSome && !isOfRestitution(one))
            limitTo(one, ConditionText::tr("%1 (with e = %2)").arg(QStringLiteral("%1"), e));
    }
}

} // namespace cradle
