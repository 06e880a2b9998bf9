// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

bool is(const std::optional<double> &p, double value)
{
    return p && std::abs(*p - value) < 3.0 * ratioBlur;
}

/// Whether circle 2 is \p ratio times as heavy in all \p hits, but for what a measurement blurs.
bool isExact(const std::vector<PairHit> &hits, double ratio)
{
    return std::all_of(hits.begin(), hits.end(), [&](const PairHit &hit) {
        const auto heavy = massRatio(hit);
        return !heavy || std::abs(*heavy - ratio) < 2e-3;
    });
}

/// Whether a student would write that exponent.
bool isPower(double p)
{
    return std::abs(2.0 * p - std::round(2.0 * p)) < 0.08;
}

LawDeviation say(const QString &headline, const QString &why, const std::vector<PairHit> &hits,
                 const std::vector<PairHit> &right)
{
    const PairHit &hit = hits.front();
    const Meeting &m = hit.meeting;
    const QString what =
        (isOnePushed(hit)
             ? ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the one "
                                "that is pushed answers as if m₂/m₁ were %5; %6 is right.")
             : ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the "
                                "change of v₁ was %5 times that of v₂; m₂/m₁ = %6 is right."))
            .arg(brief(m.radius1), brief(m.radius2), brief(m.density1), brief(m.density2),
                 brief(massRatio(hit).value_or(0.0)), brief(massRatio(right.front()).value_or(0.0)),
                 brief(m.restitution));
    return responseDeviation(headline, what + QLatin1Char(' ') + why, hit, Suspect::Masses);
}

/// m₂/m₁ in a hit of two equal circles among \p hits.
std::optional<double> equalRatioOf(const std::vector<PairHit> &hits)
{
    for (const PairHit &hit : hits) {
        const Meeting &m = hit.meeting;
        if (m.radius1 == m.radius2 && m.density1 == m.density2)
            return massRatio(hit);
    }
    return std::nullopt;
}

/// A hit in which circle 2 is another number of times as heavy; null if there is none.
const PairHit *otherRatioIn(const std::vector<PairHit> &hits, double ratio)
{
    const auto found = std::find_if(hits.begin(), hits.end(), [&](const PairHit &hit) {
        const auto heavy = massRatio(hit);
        return heavy && std::abs(*heavy / ratio - 1.0) > 3.0 * ratioBlur;
    });
    return found == hits.end() ? nullptr : &*found;
}

/// That the masses are numbers, or are worked out in two ways; nothing if they are of the circles.
std::optional<LawDeviation> numberedMasses(const MeasuredPair &own)
{
    const auto ratio = fixedMassRatio(own);
    if (!ratio)
        return std::nullopt;
    const auto say = [&](const QString &headline, const QString &body) {
        return responseDeviation(headline, body, own.equals.front(), Suspect::Masses);
    };
    const QString twoWays = ResponseText::tr("The two masses are not worked out in the same way");
    if (const auto other = equalRatioOf(own.densities);
        other && std::abs(*other / *ratio - 1.0) > ratioBlur)
        return say(twoWays,
                   ResponseText::tr(
                       "Two circles of the same radius and density answer as if circle 2 were "
                       "%1 times as heavy as circle 1, and with another density that both have "
                       "%2 times. Compare the lines for the two masses.")
                       .arg(brief(*ratio), brief(*other)));
    // Numbers are the same whatever the radii are.
    if (const PairHit *other = otherRatioIn(own.radii, *ratio))
        return say(twoWays,
                   ResponseText::tr(
                       "Two circles of the same radius and density answer as if circle 2 were "
                       "%1 times as heavy as circle 1, and with r₁ = %2 and r₂ = %3 m as if it "
                       "were %4 times. Compare the lines for the two masses.")
                       .arg(brief(*ratio), brief(other->meeting.radius1),
                            brief(other->meeting.radius2), brief(massRatio(*other).value_or(0.0))));
    return say(
        ResponseText::tr("The masses are numbers, not those of the circles"),
        ResponseText::tr("Two circles of the same radius and density answer as if circle 2 were "
                         "%1 times as heavy as circle 1. Work the masses out from `radius` and "
                         "`density`, which other scenes change.")
            .arg(brief(*ratio)));
}

/// Why each mass may stand where that of the other should.
LawDeviation exchangedMasses(const MeasuredPair &own, const MeasuredPair &right)
{
    LawDeviation exchange =
        say(ResponseText::tr("Each circle answers with the mass of the other"),
            ResponseText::tr("The heavier one is pushed away faster. Look at which "
                             "mass stands where."),
            own.radii, right.radii);
    exchange.suspect = Suspect::Formula;
    return exchange;
}

LawDeviation radiusSaid(double p, double good, const MeasuredPair &own, const MeasuredPair &right)
{
    return say(
        is(p, 0.0)   ? isExact(own.radii, 1.0)
                           ? ResponseText::tr("The hits do not depend on the radii")
                           : ResponseText::tr("The hits hardly depend on the radii")
          : isPower(p) ? ResponseText::tr("The mass grows with r to the power of %1, not %2")
                           .arg(brief(roundedExponent(p)), brief(roundedExponent(good)))
                     : ResponseText::tr("The masses do not follow the radii as those of balls do"),
        ResponseText::tr("A ball that is twice as wide is also twice as high and as deep: its "
                         "mass grows with r³."),
        own.radii, right.radii);
}

LawDeviation densitySaid(double p, double good, const MeasuredPair &own, const MeasuredPair &right)
{
    return say(is(p, 0.0) ? ResponseText::tr("The hits do not depend on the densities")
               : isPower(p)
                   ? ResponseText::tr("The mass grows with the density to the power of %1, not %2")
                         .arg(brief(roundedExponent(p)), brief(roundedExponent(good)))
                   : ResponseText::tr("The masses do not follow the densities"),
               ResponseText::tr("Mass is density times volume, for each circle its own."),
               own.densities, right.densities);
}

} // namespace

std::vector<LawDeviation> massDeviations(const MeasuredPair &own, const MeasuredPair &right)
{
    if (own.radii.empty() && own.densities.empty())
        return {};
    if (const auto push = sharedPushDeviation(own, right))
        return {*push};
    if (const auto numbers = numberedMasses(own))
        return {*numbers};
    MassExponents p(own);
    const MassExponents good(right);
    const auto isOff = [](std::optional<double> a, std::optional<double> b) {
        return a && b && std::abs(*a - *b) > 3.0 * ratioBlur;
    };
    if (isOff(p.radius, good.radius) && is(p.radius, 0.0) && (!good.density || is(p.density, 0.0)))
        return {
            say(ResponseText::tr("Both velocities change equally much, whatever the masses are"),
                ResponseText::tr("The heavier of two circles changes its velocity less. Look at "
                                 "where the masses of both enter your answer."),
                own.radii, right.radii)};
    std::vector<LawDeviation> found;
    const bool exchanged =
        p.radius && *p.radius < -ratioBlur && (!p.density || *p.density < ratioBlur);
    if (exchanged && good.radius) {
        // Masses that only change places are still those of balls.
        if (isOff(-*p.radius, good.radius) && !isPower(*p.radius))
            return {
                say(ResponseText::tr("The heavier circle is pushed away faster"),
                    ResponseText::tr("The masses do not only change places. Look at every place "
                                     "where one enters your answer."),
                    own.radii, right.radii)};
        found.push_back(exchangedMasses(own, right));
        p.radius = -*p.radius;
        if (p.density)
            p.density = -*p.density;
    }
    if (isOff(p.radius, good.radius))
        found.push_back(radiusSaid(*p.radius, *good.radius, own, right));
    if (isOff(p.density, good.density))
        found.push_back(densitySaid(*p.density, *good.density, own, right));
    return found;
}

} // namespace cradle
