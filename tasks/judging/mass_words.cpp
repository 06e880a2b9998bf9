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

/// Tells the masses of a program by what both circles get in its hits, or one of them.
struct MassTeller {
    const MeasuredPair &own;
    const MeasuredPair &right;
    std::optional<int> circle{}; ///< from 0
    bool isExchanged = false;    ///< that they stand for each other has been said

    [[nodiscard]] LawDeviation say(const QString &headline, const QString &why,
                                   std::vector<PairHit> MeasuredPair::*hits) const
    {
        const PairHit &hit = (own.*hits).front();
        const Meeting &m = hit.meeting;
        // The circle that tells, if it is one alone.
        const int one = circle                      ? *circle
                        : !isOnePushed(hit)         ? -1
                        : length(hit.push1()) > 0.0 ? 0
                                                    : 1;
        const double heavy = (circle ? massRatioFor(hit, *circle) : massRatio(hit)).value_or(0.0);
        QString what =
            isExchanged ? ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = "
                                           "%7) the masses, whichever stands where, are as 1 to "
                                           "%5; 1 to %6 is right.")
            : one >= 0
                ? ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), "
                                   "circle %8 leaves as if m₂/m₁ were %5; %6 is right.")
                : ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the "
                                   "change of v₁ was %5 times that of v₂; m₂/m₁ = %6 is right.");
        what =
            what.arg(brief(m.radius1), brief(m.radius2), brief(m.density1), brief(m.density2),
                     brief(isExchanged ? 1.0 / heavy : heavy),
                     brief(massRatio((right.*hits).front()).value_or(0.0)), brief(m.restitution));
        if (one >= 0 && !isExchanged)
            what = what.arg(one + 1);
        return responseDeviation(headline, what + QLatin1Char(' ') + why, hit, Suspect::Masses);
    }

    /// Where densities are not varied, the masses may be exchanged or the radii in them.
    [[nodiscard]] LawDeviation exchanged() const
    {
        LawDeviation exchange =
            right.densities.empty()
                ? say(ResponseText::tr("The larger of two circles answers as the lighter one"),
                      ResponseText::tr(
                          "Of the same density it is the heavier one. Look at whose radius "
                          "stands in which mass, and at which mass stands where."),
                      &MeasuredPair::radii)
                : say(circle
                          ? ResponseText::tr("Circle %1 answers as if it had the mass of the other")
                                .arg(*circle + 1)
                          : ResponseText::tr(
                              "Each circle answers as if it had the mass of the other"),
                      ResponseText::tr(
                          "The heavier one is pushed away faster. Look at what each mass is "
                          "made of, and at which stands where."),
                      &MeasuredPair::radii);
        exchange.suspect = Suspect::Formula;
        return exchange;
    }

    /// That a quantity goes into the mass of the other circle; what else is in it does not.
    [[nodiscard]] LawDeviation ofOther(std::vector<PairHit> MeasuredPair::*hits) const
    {
        const bool isRadius = hits == &MeasuredPair::radii;
        return say(
            isRadius ? ResponseText::tr("Each circle answers as if it had the other's radius")
                     : ResponseText::tr("Each circle answers as if it had the other's density"),
            isRadius ? ResponseText::tr("Look at whose radius stands in which mass, and on which "
                                        "side of a division.")
                     : ResponseText::tr("Look at whose density stands in which mass, and on "
                                        "which side of a division."),
            hits);
    }

    [[nodiscard]] LawDeviation radius(double p, double good) const
    {
        return say(
            is(p, 0.0) ? isExact(own.radii, 1.0)
                             ? ResponseText::tr("The hits do not depend on the radii")
                             : ResponseText::tr("The hits hardly depend on the radii")
            : isPower(p)
                ? ResponseText::tr("The mass grows with r to the power of %1, not %2")
                      .arg(brief(roundedExponent(p)), brief(roundedExponent(good)))
                : ResponseText::tr("The masses do not follow the radii as those of balls do"),
            is(p, 0.0)
                ? ResponseText::tr("Mass is density times volume, for each ball with its own "
                                   "radius: it grows with r³.")
                : ResponseText::tr("A ball that is twice as wide is also twice as high and "
                                   "as deep: its mass grows with r³."),
            &MeasuredPair::radii);
    }

    [[nodiscard]] LawDeviation density(double p, double good) const
    {
        return say(is(p, 0.0)   ? ResponseText::tr("The hits do not depend on the densities")
                   : isPower(p) ? ResponseText::tr(
                                      "The mass grows with the density to the power of %1, not %2")
                                      .arg(brief(roundedExponent(p)), brief(roundedExponent(good)))
                                : ResponseText::tr("The masses do not follow the densities"),
                   ResponseText::tr("Mass is density times volume, for each circle its own."),
                   &MeasuredPair::densities);
    }
};

bool isOff(std::optional<double> a, std::optional<double> b)
{
    return a && b && std::abs(*a - *b) > 3.0 * ratioBlur;
}

/// In what powers of radius and density the masses of \p own are not those of \p right.
std::vector<LawDeviation> powerDeviations(MassTeller tell, MassExponents p,
                                          const MassExponents &good)
{
    std::vector<LawDeviation> found;
    const bool exchanged =
        p.radius && *p.radius < -ratioBlur && (!p.density || *p.density < ratioBlur);
    if (exchanged && good.radius) {
        // Masses that only change places are still those of balls.
        if (isOff(-*p.radius, good.radius) && !isPower(*p.radius))
            return {tell.say(ResponseText::tr("The heavier circle is pushed away faster"),
                             ResponseText::tr("The masses do not only change places. Look at every "
                                              "place where one enters your answer."),
                             &MeasuredPair::radii)};
        found.push_back(tell.exchanged());
        tell.isExchanged = true;
        p.radius = -*p.radius;
        if (p.density)
            p.density = -*p.density;
    }
    const auto turn = [&](std::optional<double> &power, std::vector<PairHit> MeasuredPair::*hits) {
        MassTeller told = tell;
        if (power && *power < -ratioBlur && isPower(*power)) {
            found.push_back(tell.ofOther(hits));
            power = -*power;
            told.isExchanged = true;
        }
        return told;
    };
    const MassTeller ofRadii = turn(p.radius, &MeasuredPair::radii);
    if (isOff(p.radius, good.radius))
        found.push_back(ofRadii.radius(*p.radius, *good.radius));
    const MassTeller ofDensities = turn(p.density, &MeasuredPair::densities);
    if (isOff(p.density, good.density))
        found.push_back(ofDensities.density(*p.density, *good.density));
    return found;
}

/// Whether \p circle, from 0, leaves all hits of equal masses as it should along the line of
/// centres.
bool isRightAlong(const MeasuredPair &own, const MeasuredPair &right, int circle)
{
    constexpr double blur = 5e-3; // the line of centres turns a little in a step
    const auto partOf = [circle](const PairVelocities &v) {
        return circle == 0 ? v.along1 : v.along2;
    };
    for (std::size_t i = 0; i < own.equals.size(); ++i) {
        const PairHit &hit = own.equals[i];
        const PairHit &good = right.equals[i];
        if (!hit.isMet() || !hit.isAligned() || !good.isMet() || !good.isAligned()
            || std::abs(partOf(hit.leftParts()) - partOf(good.leftParts())) > blur)
            return false;
    }
    return true;
}

} // namespace

std::vector<LawDeviation> massDeviations(const MeasuredPair &own, const MeasuredPair &right,
                                         bool areEqualsRight)
{
    if (own.radii.empty() && own.densities.empty())
        return {};
    if (const auto push = sharedPushDeviation(own, right))
        return {*push};
    if (const auto numbers = numberedMasses(own))
        return {*numbers};
    const MassTeller tell{own, right};
    const MassExponents p(own);
    const MassExponents good(right);
    if (const PairHit *hit = unsharedHit(own)) {
        if (areEqualsRight)
            return {unsharedDeviation(*hit)};
        // Quotients of the masses for their shares look like masses that are squared.
        if (good.radius && is(p.radius, 2.0 * *good.radius))
            return {};
    }
    if (isOff(p.radius, good.radius) && is(p.radius, 0.0) && (!good.density || is(p.density, 0.0)))
        return {tell.say(
            ResponseText::tr("Both velocities change equally much, whatever the masses are"),
            ResponseText::tr("The heavier of two circles changes its velocity less. Look at "
                             "where the masses of both enter your answer."),
            &MeasuredPair::radii)};
    // Another fault changes what the pushes tell of masses, too.
    const auto isTold = [&](std::optional<double> q) {
        return areEqualsRight || !q || isPower(*q);
    };
    return isTold(p.radius) && isTold(p.density) ? powerDeviations(tell, p, good)
                                                 : std::vector<LawDeviation>{};
}

std::vector<LawDeviation> massDeviationsBeside(const MeasuredPair &own, const MeasuredPair &right)
{
    const MassExponents good(right);
    const auto isClear = [](std::optional<double> p, std::optional<double> wanted) {
        return !wanted || (p && isPower(*p) && std::abs(*p) > 0.4);
    };
    for (const int circle : {0, 1}) {
        const MassExponents p(own, circle);
        if (isRightAlong(own, right, circle) && isClear(p.radius, good.radius)
            && isClear(p.density, good.density))
            return powerDeviations({own, right, circle}, p, good);
    }
    return {};
}

} // namespace cradle
