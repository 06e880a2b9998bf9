// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cradle {

namespace {

/// One circle always leaves as it should, and the other does not where the masses differ.
std::optional<LawDeviation> pushOnOne(const MeasuredPair &own, const MeasuredPair &right)
{
    std::array<bool, 2> isRight{true, true};
    const PairHit *shown = nullptr;
    const PairHit *good = nullptr;
    const auto same = [](const PairHit &a, const PairHit &b) {
        return length(a.left1 - b.left1) + length(a.left2 - b.left2)
               < 0.01 * (length(b.left1) + length(b.left2));
    };
    if (!std::equal(own.equals.begin(), own.equals.end(), right.equals.begin(), right.equals.end(),
                    same))
        return std::nullopt;
    const double e = own.equals.front().meeting.restitution;
    const auto look = [&](const std::vector<PairHit> &mine, const std::vector<PairHit> &theirs) {
        for (std::size_t i = 0; i < mine.size(); ++i) {
            if (mine[i].meeting.restitution != e || !mine[i].isMet() || !theirs[i].isMet()
                || !mine[i].isAligned() || !theirs[i].isAligned())
                continue;
            const double slack = 0.01 * (length(theirs[i].left1) + length(theirs[i].left2));
            const bool one = length(mine[i].left1 - theirs[i].left1) < slack;
            const bool two = length(mine[i].left2 - theirs[i].left2) < slack;
            isRight = {isRight[0] && one, isRight[1] && two};
            if (!shown && one != two) {
                shown = &mine[i];
                good = &theirs[i];
            }
        }
    };
    look(own.radii, right.radii);
    look(own.densities, right.densities);
    if (!shown || isRight[0] == isRight[1])
        return std::nullopt;
    LawDeviation found = responseDeviation(
        ResponseText::tr("Where the masses differ, only circle %1 leaves as it should")
            .arg(isRight[0] ? 1 : 2),
        describeHit(*shown, *good) + QLatin1Char(' ')
            + ResponseText::tr("Look at which masses and which signs stand in what is worked out "
                               "for the other one."),
        *shown);
    found.moment.circles = {isRight[0] ? 1 : 0};
    return found;
}

/// Right in what both have in common, while each gets the other's share of the rebound:
///     Δv₁ = −(m₂ + e m₁) / (m₁ + m₂) u, which is no different from equal masses where e is 1.
std::optional<LawDeviation> exchangedRebound(const MeasuredPair &own, const MeasuredPair &right)
{
    const PairHit *shown = nullptr;
    const PairHit *good = nullptr;
    const auto holds = [&](const std::vector<PairHit> &mine, const std::vector<PairHit> &theirs) {
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const PairHit &hit = mine[i];
            if (!hit.isMet() || !theirs[i].isMet() || !hit.isAligned() || !theirs[i].isAligned())
                return false;
            const Meeting &m = hit.meeting;
            const double m1 = m.density1 * std::pow(m.radius1, 3.0);
            const double m2 = m.density2 * std::pow(m.radius2, 3.0);
            const PairVelocities in = hit.cameParts();
            const PairVelocities out = hit.leftParts();
            const double share = (in.along1 - in.along2) / (m1 + m2);
            const double e = m.restitution;
            const double slack = 0.01 * (1.0 + std::abs(in.along1 - in.along2));
            if (std::abs(out.along1 - in.along1 + share * (m2 + e * m1)) > slack
                || std::abs(out.along2 - in.along2 - share * (m1 + e * m2)) > slack)
                return false;
            if (m1 != m2 && e > 0.1 && e < 0.9) {
                shown = &hit;
                good = &theirs[i];
            }
        }
        return true;
    };
    if (!holds(own.radii, right.radii) || !holds(own.densities, right.densities) || !shown)
        return std::nullopt;
    return responseDeviation(
        ResponseText::tr("In the rebound the two shares are exchanged"),
        ResponseText::tr("With ρ₁ = %1 and ρ₂ = %2, e = %3: ")
                .arg(brief(shown->meeting.density1), brief(shown->meeting.density2),
                     brief(shown->meeting.restitution))
            + describeHit(*shown, *good) + QLatin1Char(' ')
            + ResponseText::tr(
                "What both have in common comes out right. Of the rebound, the part "
                "with e, circle 1 gets the share m₁/(m₁ + m₂) and circle 2 the share "
                "m₂/(m₁ + m₂): the lighter one should get more."),
        *shown, Suspect::Formula);
}

/// Two changes of velocity whose ratio hangs on e are not those of one push.
std::optional<LawDeviation> lostMomentum(const MeasuredPair &own, const MeasuredPair &right)
{
    // What goes wrong between equal circles, too, is another law.
    const auto isSame = [](const PairHit &a, const PairHit &b) {
        return length(a.left1 - b.left1) + length(a.left2 - b.left2)
               < 0.01 * (length(b.left1) + length(b.left2));
    };
    if (!std::equal(own.rebounds.begin(), own.rebounds.end(), right.rebounds.begin(),
                    right.rebounds.end(), isSame))
        return std::nullopt;
    for (const PairHit &hit : own.densities) {
        const auto same =
            std::find_if(own.densities.begin(), own.densities.end(), [&](const PairHit &other) {
                return other.meeting.density1 == hit.meeting.density1
                       && other.meeting.density2 == hit.meeting.density2
                       && other.meeting.restitution != hit.meeting.restitution;
            });
        if (same == own.densities.end())
            continue;
        const auto one = massRatio(hit);
        const auto two = massRatio(*same);
        const std::size_t at = static_cast<std::size_t>(&hit - own.densities.data());
        const auto good = massRatio(right.densities[at]);
        if (!one || !two || !good || std::abs(*one / *two - 1.0) < 0.05)
            continue;
        return responseDeviation(
            ResponseText::tr("Where the masses differ, the total momentum is not kept"),
            ResponseText::tr(
                "With ρ₁ = %1 and ρ₂ = %2 the change of v₁ was %3 times that of v₂ where "
                "e is %4, and %5 times where it is %6; m₂/m₁ = %7 is right, whatever e "
                "is. One push changes both: look at what the two formulas have in "
                "common.")
                .arg(brief(hit.meeting.density1), brief(hit.meeting.density2), brief(*one),
                     brief(hit.meeting.restitution), brief(*two), brief(same->meeting.restitution),
                     brief(*good)),
            hit, Suspect::Formula);
    }
    return std::nullopt;
}

} // namespace

std::optional<LawDeviation> sharedPushDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    for (const auto look : {pushOnOne, exchangedRebound, lostMomentum}) {
        if (auto found = look(own, right))
            return found;
    }
    return std::nullopt;
}

} // namespace cradle
