// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cradle {

namespace {

constexpr double constantBlur = 5e-3;  ///< m/s; the line of centres turns a little in a step
constexpr std::size_t fewestAlike = 3; ///< hits; two may end alike by chance

/// Whether \p valueOf is the same for all of \p some.
template <class One, class Value>
bool isConstant(const std::vector<One> &some, Value valueOf)
{
    return std::all_of(some.begin(), some.end(), [&](const One &one) {
        return length(valueOf(one) - valueOf(some.front())) < constantBlur;
    });
}

/// The velocities of the two, one after the other, m/s.
Vec2 velocityAfter(const PairHit &hit, int circle)
{
    return hit.slowness * (circle == 0 ? hit.left1 : hit.left2);
}

/// The parts of the two along the line of centres, m/s.
Vec2 alongParts(const PairVelocities &v)
{
    return {v.along1, v.along2};
}

} // namespace

std::optional<LawDeviation> constantDeviation(const MeasuredPair &own,
                                              const std::vector<EqualHit> &hits, const PairHit &hit)
{
    std::vector<PairHit> all;
    for (const auto *some : {&own.equals, &own.radii, &own.densities, &own.rebounds})
        std::copy_if(some->begin(), some->end(), std::back_inserter(all),
                     [](const PairHit &one) { return one.isMet() && one.isAligned(); });
    if (all.size() < fewestAlike)
        return std::nullopt;
    const auto isOfCircle = [&](int circle) {
        return isConstant(all, [=](const PairHit &one) { return velocityAfter(one, circle); });
    };
    const QString before =
        QLatin1Char(' ')
        + ResponseText::tr("What a hit makes is worked out from the velocities before it.");
    if (isOfCircle(0) && isOfCircle(1))
        return responseDeviation(
            ResponseText::tr("The velocities after a hit do not depend on those before"),
            ResponseText::tr("From all hits tried circle 1 leaves with %1 m/s and circle 2 with %2 "
                             "m/s.")
                    .arg(brief(velocityAfter(hit, 0)), brief(velocityAfter(hit, 1)))
                + before,
            hit);
    const auto parts = [](const PairHit &one) {
        return one.slowness * alongParts(one.leftParts());
    };
    // Where one has the part that it should have, the other may just have lost its own.
    const auto isLost = [&](double PairVelocities::*right, double PairVelocities::*other) {
        return std::abs(hit.leftParts().*other) < constantBlur
               && std::all_of(hits.begin(), hits.end(), [&](const EqualHit &h) {
                      return std::abs(h.hit.leftParts().*right - h.right.*right) < constantBlur;
                  });
    };
    if (!isConstant(all, parts) || isLost(&PairVelocities::along1, &PairVelocities::along2)
        || isLost(&PairVelocities::along2, &PairVelocities::along1)
        || isConstant(hits, [](const EqualHit &h) { return alongParts(h.right); }))
        return std::nullopt;
    return responseDeviation(
        ResponseText::tr("The new parts along the normal do not depend on the old ones"),
        ResponseText::tr("Along the line of centres, from 1 to 2, circle 1 leaves all hits tried "
                         "with %1 m/s and circle 2 with %2 m/s.")
                .arg(brief(hit.slowness * hit.seenPart(hit.leftParts().along1)),
                     brief(hit.slowness * hit.seenPart(hit.leftParts().along2)))
            + before,
        hit);
}

} // namespace cradle
