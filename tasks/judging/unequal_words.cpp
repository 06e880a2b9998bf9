// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cradle {

namespace {

/// m₂/m₁ of balls.
double ballRatioOf(const Meeting &m)
{
    return std::pow(m.radius2 / m.radius1, 3) * m.density2 / m.density1;
}

/// What equal circles do, by circles of those masses: the push on each is its share of it.
PairVelocities asBalls(const EqualHit &h)
{
    const double heavy = ballRatioOf(h.hit.meeting);
    PairVelocities v = h.right;
    v.along1 = h.in.along1 + 2.0 * heavy / (1.0 + heavy) * (h.right.along1 - h.in.along1);
    v.along2 = h.in.along2 + 2.0 / (1.0 + heavy) * (h.right.along2 - h.in.along2);
    return v;
}

/// Whether \p a is \p b but for what a reader would not see.
bool isAbout(const PairVelocities &a, const PairVelocities &b)
{
    constexpr double clear = 0.05; // m/s, of some
    return std::abs(a.along1 - b.along1) + std::abs(a.along2 - b.along2)
               + std::abs(a.across1 - b.across1) + std::abs(a.across2 - b.across2)
           < clear;
}

/// What the reference made of \p hit, a hit of circles of different radii or densities.
const PairHit &beside(const PairHit &hit, const MeasuredPair &own, const MeasuredPair &right)
{
    for (std::size_t i = 0; i < own.radii.size(); ++i) {
        if (&own.radii[i] == &hit)
            return right.radii[i];
    }
    return right.densities[static_cast<std::size_t>(&hit - own.densities.data())];
}

QString radiiOf(const Meeting &m)
{
    return ResponseText::tr("With r₁ = %1 and r₂ = %2 m: ").arg(brief(m.radius1), brief(m.radius2));
}

} // namespace

std::optional<LawDeviation> sizeDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    const std::vector<EqualHit> hits = comparableHits(own.sizes, right.sizes);
    const auto comesOut = [](const EqualHit &h) {
        const PairVelocities left = h.hit.leftParts();
        return isAbout(left, h.right) || isAbout(left, asBalls(h));
    };
    const auto isRight = [](const PairHit &hit, const PairHit &good) {
        return hit.isMet() && good.isMet()
               && isSameAnswer(hit.leftParts(), rightFor(hit.cameParts(), good));
    };
    // Of equal circles a larger pair comes out right, too.
    if (hits.size() < 2 || std::any_of(hits.begin(), hits.end(), comesOut) || !own.larger
        || !right.larger || !isRight(*own.larger, *right.larger))
        return std::nullopt;
    const auto at = static_cast<std::size_t>(&hits.front().hit - own.sizes.data());
    const PairHit &hit = own.sizes[at];
    return responseDeviation(
        ResponseText::tr("Circles of different radii come out of a hit wrong"),
        radiiOf(hit.meeting) + describeHit(hit, right.sizes[at]) + QLatin1Char(' ')
            + ResponseText::tr("Circles of the same radius come out right: look at where the radii "
                               "enter what each of the two gets of the other."),
        hit, Suspect::Formula);
}

std::optional<LawDeviation> loneMassDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    std::vector<EqualHit> hits = comparableHits(own.radii, right.radii);
    const std::vector<EqualHit> more = comparableHits(own.densities, right.densities);
    std::copy(more.begin(), more.end(), std::back_inserter(hits));
    const auto isUnequal = [](const EqualHit &h) {
        return std::abs(ballRatioOf(h.hit.meeting) - 1.0) > 0.1;
    };
    if (std::count_if(hits.begin(), hits.end(), isUnequal) < 2)
        return std::nullopt;
    for (const int circle : {1, 2}) {
        const auto isOfOne = [circle](const EqualHit &h) {
            const double heavy = ballRatioOf(h.hit.meeting);
            const double share = 0.5 * (1.0 + (circle == 1 ? 1.0 / heavy : heavy));
            return isSameAnswer(h.hit.leftParts(), pushed(h, share));
        };
        if (!std::all_of(hits.begin(), hits.end(), isOfOne))
            continue;
        const EqualHit &shown = *std::find_if(hits.begin(), hits.end(), isUnequal);
        const PairHit &good = beside(shown.hit, own, right);
        return responseDeviation(
            ResponseText::tr("The size of the push hangs on the mass of circle %1 alone")
                .arg(circle),
            radiiOf(shown.hit.meeting) + describeHit(shown.hit, good) + QLatin1Char(' ')
                + ResponseText::tr("In all hits tried both pushes are as large as if both circles "
                                   "had the mass of circle %1; what each makes of its own push is "
                                   "right. Look at which masses stand in the size of the push.")
                      .arg(circle),
            shown.hit, Suspect::Formula);
    }
    return std::nullopt;
}

} // namespace cradle
