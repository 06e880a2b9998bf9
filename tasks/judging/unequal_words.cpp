// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace cradle {

namespace {

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

/// In what two circles differ.
QString unlikeIn(const Meeting &m)
{
    return m.radius1 != m.radius2
               ? radiiOf(m)
               : ResponseText::tr("With ρ₁ = %1 and ρ₂ = %2, e = %3: ")
                     .arg(brief(m.density1), brief(m.density2), brief(m.restitution));
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

namespace {

using Uneven = const EqualHit &;

/// Both pushes as large as if both circles had the mass of that one, from 1:
///     J = (1 + e) m/2 u  in place of  (1 + e) m₁ m₂ / (m₁ + m₂) u
ResponseLaw loneMass(int circle)
{
    const auto ofFirst = [](Uneven h) {
        return pushed(h, 0.5 * (1.0 + 1.0 / ballRatioOf(h.hit.meeting)));
    };
    const auto ofSecond = [](Uneven h) {
        return pushed(h, 0.5 * (1.0 + ballRatioOf(h.hit.meeting)));
    };
    return {
        circle == 1 ? +ofFirst : +ofSecond,
        ResponseText::tr("The size of the push hangs on the mass of circle %1 alone").arg(circle),
        ResponseText::tr("In all hits tried both pushes are as large as if both circles "
                         "had the mass of circle %1; what each makes of its own push is "
                         "right. Look at which masses stand in the size of the push.")
            .arg(circle)};
}

/// (m₁ + m₂) / (m₁ − m₂)
double sumByDifference(const EqualHit &h)
{
    const double heavy = ballRatioOf(h.hit.meeting);
    return (1.0 + heavy) / (1.0 - heavy);
}

/// What both have in common, and what parts them, for masses of balls:
///     v₁ = c − e m₂/(m₁ + m₂) u,   c = (m₁ v₁ + m₂ v₂) / (m₁ + m₂)
/// with one of the two as for equal masses in place of that.
std::vector<ResponseLaw> halfMeantLaws()
{
    return {
        {[](Uneven h) {
             const double heavy = ballRatioOf(h.hit.meeting);
             const double off = 0.5 * (h.in.along1 + h.in.along2)
                                - (h.in.along1 + heavy * h.in.along2) / (1.0 + heavy);
             return PairVelocities{h.right.along1 + off, h.right.across1, h.right.along2 + off,
                                   h.right.across2};
         },
         ResponseText::tr("What the two have in common does not depend on the masses"),
         ResponseText::tr("In all hits tried what parts them again comes out right, but what both "
                          "have in common is the mean of the two velocities along that line, "
                          "whatever the masses are. The total momentum is not kept then, so no "
                          "masses make it right. Look at where that mean is worked out.")},
        {[](Uneven h) {
             const double heavy = ballRatioOf(h.hit.meeting);
             const double off = h.hit.meeting.restitution * (h.in.along1 - h.in.along2)
                                * (heavy / (1.0 + heavy) - 0.5);
             return PairVelocities{h.right.along1 + off, h.right.across1, h.right.along2 + off,
                                   h.right.across2};
         },
         ResponseText::tr("The rebound is shared half and half, whatever the masses are"),
         ResponseText::tr("In all hits tried what both have in common comes out right, but of what "
                          "parts them again each gets one half. The total momentum is not kept "
                          "then, so no masses make it right: the lighter one should get more.")}};
}

/// Answers with the masses of balls in which these stand in a wrong place.
std::vector<ResponseLaw> unevenLaws()
{
    const QString look = QLatin1Char(' ')
                         + ResponseText::tr("Look at where the two masses are subtracted, and "
                                            "where they are added.");
    std::vector<ResponseLaw> laws = halfMeantLaws();
    const std::vector<ResponseLaw> others{
        loneMass(1),
        loneMass(2),
        {[](Uneven h) {
             return PairVelocities{h.right.along2, h.right.across1, h.right.along1,
                                   h.right.across2};
         },
         ResponseText::tr("Each circle gets the new part of the other"),
         ResponseText::tr("In all hits tried both new parts along the line of centres are as "
                          "they should be, but circle 1 has that of circle 2, and circle 2 "
                          "that of circle 1. Look at which result goes to which circle.")},
        {[](Uneven h) {
             const double heavy = ballRatioOf(h.hit.meeting);
             return PairVelocities{heavy * h.in.along2, h.in.across1, h.in.along1 / heavy,
                                   h.in.across2};
         },
         ResponseText::tr("The momenta along the line of centres change hands"),
         ResponseText::tr("In all hits tried each circle has after the hit the momentum along "
                          "that line that the other came with. That keeps the total momentum, "
                          "but where the masses differ they do not part as fast as they "
                          "met.")},
        {[](Uneven h) {
             const double heavy = ballRatioOf(h.hit.meeting);
             const double e = h.hit.meeting.restitution;
             return PairVelocities{e * heavy * h.in.along2, h.in.across1, e * h.in.along1 / heavy,
                                   h.in.across2};
         },
         ResponseText::tr("Each circle leaves with e times the momentum of the other"),
         ResponseText::tr("In all hits tried each circle has after the hit e times the momentum "
                          "along that line that the other came with. The total momentum is not "
                          "kept then: e acts on how fast they part alone.")},
        {[](Uneven h) {
             return PairVelocities{sumByDifference(h) * h.right.along1, h.right.across1,
                                   sumByDifference(h) * h.right.along2, h.right.across2};
         },
         ResponseText::tr("The new parts along the line of centres have a wrong size"),
         ResponseText::tr("In all hits tried of two masses both new parts are (m₁ + m₂) / "
                          "(m₁ − m₂) times what is right.")
             + look},
        {[](Uneven h) { return pushed(h, sumByDifference(h)); },
         ResponseText::tr("Both pushes have a wrong size"),
         ResponseText::tr("In all hits tried of two masses both pushes are (m₁ + m₂) / "
                          "(m₁ − m₂) times what is right.")
             + look}};
    laws.insert(laws.end(), others.begin(), others.end());
    return laws;
}

/// All hits of two programs that compare, of equal and of unequal circles, with every e.
std::vector<EqualHit> allHits(const MeasuredPair &own, const MeasuredPair &right)
{
    std::vector<EqualHit> all;
    for (const auto hits : {&MeasuredPair::radii, &MeasuredPair::densities, &MeasuredPair::equals,
                            &MeasuredPair::rebounds}) {
        const std::vector<EqualHit> more = comparableHits(own.*hits, right.*hits);
        // Where a mass is divided by none, nothing of the answer is a number.
        std::copy_if(more.begin(), more.end(), std::back_inserter(all), [](const EqualHit &h) {
            return !h.hit.stopped && std::isfinite(h.hit.left1.x + h.hit.left2.x);
        });
    }
    return all;
}

bool isUneven(const EqualHit &h)
{
    return std::abs(ballRatioOf(h.hit.meeting) - 1.0) > 0.1;
}

} // namespace

std::optional<ResponseLaw> unevenLaw(const MeasuredPair &own, const MeasuredPair &right)
{
    const std::vector<EqualHit> hits = allHits(own, right);
    if (std::count_if(hits.begin(), hits.end(), isUneven) < 2)
        return std::nullopt;
    const std::vector<ResponseLaw> laws = unevenLaws();
    const auto found = std::find_if(laws.begin(), laws.end(),
                                    [&](const ResponseLaw &law) { return follows(law, hits); });
    return found == laws.end() ? std::nullopt : std::optional(*found);
}

std::optional<LawDeviation> unevenDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    const auto law = unevenLaw(own, right);
    if (!law)
        return std::nullopt;
    const std::vector<EqualHit> hits = allHits(own, right);
    const EqualHit &shown = *std::find_if(hits.begin(), hits.end(), isUneven);
    const PairHit &good = beside(shown.hit, own, right);
    return responseDeviation(law->headline,
                             unlikeIn(shown.hit.meeting) + describeHit(shown.hit, good)
                                 + QLatin1Char(' ') + law->body,
                             shown.hit, Suspect::Formula);
}

} // namespace cradle
