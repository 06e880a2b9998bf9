// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

QString degreesOf(Vec2 n)
{
    return brief(std::atan2(n.y, n.x) * 180.0 / std::numbers::pi);
}

/// The line of centres of a hit, at the start of its step or at its end, whichever is nearer to n.
Vec2 lineNear(Vec2 n, const PairHit &hit)
{
    return std::abs(cross(n, hit.normal)) < std::abs(cross(n, hit.nextNormal)) ? hit.normal
                                                                               : hit.nextNormal;
}

} // namespace

LawDeviation keptLineDeviation(const PairHit &first, const PairHit &wrong)
{
    return responseDeviation(
        ResponseText::tr("A later hit is answered along the line of an earlier one"),
        ResponseText::tr("In the first hit of a run the line of centres was at %1°, in a later one "
                         "at %2°. Both times the push was along the first line. Every hit has a "
                         "normal of its own: work it out anew.")
            .arg(degreesOf(first.normal), degreesOf(wrong.normal)),
        wrong, Suspect::Kept);
}

std::optional<LawDeviation> laterDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    if (!own.later || !right.later)
        return std::nullopt;
    const PairHit &one = own.later->first;
    const PairHit &two = own.later->second;
    const Vec2 n1 = normalized(one.push2());
    const Vec2 n2 = normalized(two.push2());
    const auto off = [](Vec2 n, const PairHit &hit) {
        return std::min(std::abs(cross(n, hit.normal)), std::abs(cross(n, hit.nextNormal)));
    };
    constexpr double sameLine = 0.02; // rad: what is farther off is another's
    if (off(n1, one) < sameLine && off(n2, two) > 0.15 && length(n2 - n1) < 1e-3) {
        return responseDeviation(
            ResponseText::tr("A later hit is answered along the line of an earlier one"),
            ResponseText::tr("Two circles met with their line of centres at %1°, and again, "
                             "back from a wall, with it at %2°. Both times they were pushed "
                             "along %3°. Every hit has a normal of its own: work it out anew.")
                .arg(degreesOf(lineNear(n1, one)), degreesOf(lineNear(n2, two)), degreesOf(n2)),
            two, Suspect::Kept);
    }
    const double e = one.meeting.restitution;
    const double first = one.rebound();
    const double second = two.rebound();
    // Who answers far from the other may have met a wall in between.
    if (!one.isInTime() || !two.isInTime() || off(n1, one) >= 0.1 || off(n2, two) >= 0.1
        || std::abs(first - e) >= 0.01 || std::abs(second - e) <= 0.03)
        return std::nullopt;
    if (own.later->isOfHistory())
        return responseDeviation(
            ResponseText::tr("A later hit is answered with another e"),
            ResponseText::tr("With e = %1 two circles parted with %2 times the speed that they "
                             "met with; in their second hit, back from a wall, it was %3 "
                             "times. Look at what your program keeps from one hit to the next.")
                .arg(brief(e), brief(first), brief(second)),
            two, Suspect::Kept);
    // As the first of a run it comes out so, too.
    const PairHit &hit = own.later->anew;
    if (!hit.isMet())
        return std::nullopt;
    LawDeviation said = responseDeviation(
        ResponseText::tr("Some hits of the two circles come out wrong"),
        ResponseText::tr("With e = %1 and a timestep of %2 s the circles parted with %3 times the "
                         "speed along the push that they met with; %4 is right.")
            .arg(brief(e), briefTimestep(hit.stage.preset.timestep), brief(hit.rebound()),
                 brief(e)),
        hit, Suspect::Formula);
    said.isConditional = true;
    return said;
}

LawDeviation lateRestitution(const MeasuredPair &own)
{
    const PairHit &one = own.later->first;
    return responseDeviation(
        ResponseText::tr("e acts only after the first hit"),
        ResponseText::tr("With e = %1 two circles parted with %2 times the speed that they met "
                         "with; in their second hit, back from a wall, it was %3 times. Look "
                         "at when your answer learns what e is: that comes too late.")
            .arg(brief(one.meeting.restitution), brief(one.rebound()),
                 brief(own.later->second.rebound())),
        one, Suspect::Kept);
}

std::optional<LawDeviation> overlapDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    constexpr double blur = 0.01;
    const PairHit *shown = nullptr;
    double shownRight = 0.0;
    for (std::size_t i = 0; i < own.contacts.size(); ++i) {
        const PairHit &hit = own.contacts[i];
        const double e = right.contacts[i].rebound();
        if (!hit.isInTime() || !right.contacts[i].isInTime())
            continue;
        // A normal of length s makes the push (1 + e) u the s²-fold.
        const double s = std::sqrt((1.0 + hit.rebound()) / (1.0 + e));
        const double sum = hit.meeting.sum();
        if (!(s > hit.reached / sum - blur && s < hit.before / sum + blur))
            return std::nullopt;
        if (!shown && std::abs(hit.rebound() - e) > blur) {
            shown = &hit;
            shownRight = e;
        }
    }
    if (!shown)
        return std::nullopt;
    const bool isOfE = !own.rebounds.empty();
    const QString seen =
        isOfE ? ResponseText::tr("With e = %1 and a timestep of %2 s the circles parted with %3 "
                                 "times the speed along the push that they met with; %4 is right.")
                    .arg(brief(shown->meeting.restitution))
              : ResponseText::tr("With a timestep of %1 s the circles parted with %2 times the "
                                 "speed along the push that they met with; %3 is right.");
    return responseDeviation(
        ResponseText::tr("The rebound depends on how deep the circles overlap"),
        seen.arg(briefTimestep(shown->stage.preset.timestep), brief(shown->rebound()),
                 brief(shownRight))
            + QLatin1Char(' ')
            + ResponseText::tr("In very short steps it comes out right: look at whether the normal "
                               "has length 1 where they overlap."),
        *shown, Suspect::Formula);
}

namespace {

/// Velocities after a hit in units of the speed with which they came nearer: how a slow one differs
/// is small beside 1 m/s.
PairVelocities inUnits(const PairHit &hit, const PairVelocities &left)
{
    const double unit = 1.0 / hit.meeting.closing();
    return {unit * left.along1, unit * left.across1, unit * left.along2, unit * left.across2};
}

} // namespace

std::optional<LawDeviation> slowDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    if (!own.slow || !right.slow || !own.slow->isMet() || !own.slow->isAligned()
        || !right.slow->isMet())
        return std::nullopt;
    const PairHit &hit = *own.slow;
    if (isSameAnswer(inUnits(hit, hit.leftParts()),
                     inUnits(hit, rightFor(hit.cameParts(), *right.slow))))
        return std::nullopt;
    const double closing = own.equals.front().meeting.closing();
    LawDeviation said = responseDeviation(
        ResponseText::tr("Circles that meet slowly are answered in another way"),
        ResponseText::tr("With e = %1: ").arg(brief(hit.meeting.restitution))
            + describeHit(hit, *right.slow) + QLatin1Char(' ')
            + ResponseText::tr("Where they meet with %1 m/s, it comes out right. The law is "
                               "the same for every speed.")
                  .arg(brief(hit.slowness * closing)),
        hit, Suspect::Formula);
    said.topic = Topic::Slowness;
    return said;
}

} // namespace cradle
