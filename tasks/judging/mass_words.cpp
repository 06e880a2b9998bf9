// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_reading.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

struct MassText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

constexpr double ratioBlur = 0.01;    ///< of exponents
constexpr double antiparallel = 0.02; ///< of the directions of two pushes

/// The exponent in mass ∝ q^p that all \p hits agree in; \p ratio gives q₂ / q₁.
template <class Ratio>
std::optional<double> exponentOf(const std::vector<PairHit> &hits, Ratio ratio)
{
    std::optional<double> exponent;
    for (const PairHit &hit : hits) {
        const double q = ratio(hit.meeting);
        if (std::abs(q - 1.0) < 1e-9)
            continue;
        const auto heavy = massRatio(hit);
        if (!heavy)
            return std::nullopt;
        const double p = std::log(*heavy) / std::log(q);
        if (exponent && std::abs(*exponent - p) > 3.0 * ratioBlur * (1.0 + std::abs(p)))
            return std::nullopt;
        exponent = p;
    }
    return exponent;
}

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

double rounded(double p)
{
    return std::round(p * 50.0) / 50.0;
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
        MassText::tr(
            "With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the change of v₁ was %5 "
            "times that of v₂; m₂/m₁ = %6 is right.")
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
    return responseDeviation(
        MassText::tr("Where the masses differ, only circle %1 leaves as it should")
            .arg(isRight[0] ? 1 : 2),
        describeHit(*shown, *good) + QLatin1Char(' ')
            + MassText::tr("Look at which mass the other one is pushed with: each change of a "
                           "velocity is the push divided by the circle's own mass."),
        *shown);
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
        MassText::tr("In the rebound each circle has the mass of the other"),
        MassText::tr("With ρ₁ = %1 and ρ₂ = %2, e = %3: ")
                .arg(brief(shown->meeting.density1), brief(shown->meeting.density2),
                     brief(shown->meeting.restitution))
            + describeHit(*shown, *good) + QLatin1Char(' ')
            + MassText::tr("What both have in common comes out right. Of the rebound, the part "
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
            MassText::tr("Where the masses differ, the total momentum is not kept"),
            MassText::tr("With ρ₁ = %1 and ρ₂ = %2 the change of v₁ was %3 times that of v₂ where "
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

bool isHeadOn(const PairHit &hit)
{
    const PairVelocities in = hit.cameParts();
    return std::abs(in.across1) + std::abs(in.across2)
           < 1e-9 * (std::abs(in.along1) + std::abs(in.along2));
}

std::optional<double> massRatio(const PairHit &hit)
{
    const double p1 = length(hit.push1());
    const double p2 = length(hit.push2());
    if (!hit.isMet() || p1 < 1e-6 || p2 < 1e-6)
        return std::nullopt;
    const Vec2 sum = hit.push1() / p1 + hit.push2() / p2;
    return length(sum) < antiparallel ? std::optional(p1 / p2) : std::nullopt;
}

MassExponents::MassExponents(const MeasuredPair &pair)
    : radius(exponentOf(pair.radii, [](const Meeting &m) { return m.radius2 / m.radius1; }))
    , density(exponentOf(pair.densities, [](const Meeting &m) { return m.density2 / m.density1; }))
{
}

double MassExponents::ratioOf(const Meeting &m) const
{
    return std::pow(m.radius2 / m.radius1, rounded(radius.value_or(3.0)))
           * std::pow(m.density2 / m.density1, rounded(density.value_or(1.0)));
}

std::optional<double> fixedMassRatio(const MeasuredPair &pair)
{
    std::optional<double> ratio;
    for (const PairHit &hit : pair.equals) {
        if (!hit.isMet())
            continue;
        const auto heavy = massRatio(hit);
        if (!heavy || (ratio && std::abs(*heavy - *ratio) > ratioBlur * *ratio))
            return std::nullopt;
        // Two masses share what an elastic hit changes: (m₂ + m₁) / (m₁ + m₂) of 2 u.
        const double u = dot(hit.came1 - hit.came2, normalized(hit.push2()));
        if (std::abs(length(hit.push1()) + length(hit.push2()) - 2.0 * u) > 0.02 * std::abs(u))
            return std::nullopt;
        ratio = heavy;
    }
    return ratio && std::abs(*ratio - 1.0) > 3.0 * ratioBlur ? ratio : std::nullopt;
}

std::vector<LawDeviation> massDeviations(const MeasuredPair &own, const MeasuredPair &right)
{
    if (own.radii.empty() && own.densities.empty())
        return {};
    if (const auto one = pushOnOne(own, right))
        return {*one};
    if (const auto rebound = exchangedRebound(own, right))
        return {*rebound};
    if (const auto lost = lostMomentum(own, right))
        return {*lost};
    const auto ratio = fixedMassRatio(own);
    if (const auto other = ratio ? equalRatioOf(own.densities) : std::nullopt;
        other && std::abs(*other / *ratio - 1.0) > ratioBlur)
        return {responseDeviation(
            MassText::tr("The two masses are not worked out in the same way"),
            MassText::tr("Two circles of the same radius and density answer as if circle 2 were "
                         "%1 times as heavy as circle 1, and with another density that both have "
                         "%2 times. Compare the lines for the two masses.")
                .arg(brief(*ratio), brief(*other)),
            own.equals.front(), Suspect::Masses)};
    // Numbers are the same whatever the radii are.
    if (const PairHit *other = ratio ? otherRatioIn(own.radii, *ratio) : nullptr)
        return {responseDeviation(
            MassText::tr("The two masses are not worked out in the same way"),
            MassText::tr("Two circles of the same radius and density answer as if circle 2 were "
                         "%1 times as heavy as circle 1, and with r₁ = %2 and r₂ = %3 m as if it "
                         "were %4 times. Compare the lines for the two masses.")
                .arg(brief(*ratio), brief(other->meeting.radius1), brief(other->meeting.radius2),
                     brief(massRatio(*other).value_or(0.0))),
            own.equals.front(), Suspect::Masses)};
    if (ratio)
        return {responseDeviation(
            MassText::tr("The masses are numbers, not those of the circles"),
            MassText::tr("Two circles of the same radius and density answer as if circle 2 were "
                         "%1 times as heavy as circle 1. Work the masses out from `radius` and "
                         "`density`, which other scenes change.")
                .arg(brief(*ratio)),
            own.equals.front(), Suspect::Masses)};
    MassExponents p(own);
    const MassExponents good(right);
    const auto isOff = [](std::optional<double> a, std::optional<double> b) {
        return a && b && std::abs(*a - *b) > 3.0 * ratioBlur;
    };
    if (isOff(p.radius, good.radius) && is(p.radius, 0.0) && (!good.density || is(p.density, 0.0)))
        return {say(MassText::tr("The circles answer as if they were equally heavy"),
                    MassText::tr("Look at where the masses of both enter your answer."), own.radii,
                    right.radii)};
    std::vector<LawDeviation> found;
    const bool exchanged =
        p.radius && *p.radius < -ratioBlur && (!p.density || *p.density < ratioBlur);
    if (exchanged && good.radius) {
        // Masses that only change places are still those of balls.
        if (isOff(-*p.radius, good.radius) && !isPower(*p.radius))
            return {say(MassText::tr("The heavier circle is pushed away faster"),
                        MassText::tr("The masses do not only change places. Look at every place "
                                     "where one enters your answer."),
                        own.radii, right.radii)};
        LawDeviation exchange =
            say(MassText::tr("Each circle answers with the mass of the other"),
                MassText::tr("The heavier one is pushed away faster. Look at which "
                             "mass stands where."),
                own.radii, right.radii);
        exchange.suspect = Suspect::Formula;
        found.push_back(std::move(exchange));
        p.radius = -*p.radius;
        if (p.density)
            p.density = -*p.density;
    }
    if (isOff(p.radius, good.radius))
        found.push_back(
            say(is(p.radius, 0.0) ? isExact(own.radii, 1.0)
                                        ? MassText::tr("The hits do not depend on the radii")
                                        : MassText::tr("The hits hardly depend on the radii")
                : isPower(*p.radius)
                    ? MassText::tr("The mass grows with r to the power of %1, not %2")
                          .arg(brief(rounded(*p.radius)), brief(rounded(*good.radius)))
                    : MassText::tr("The masses do not follow the radii as those of balls do"),
                MassText::tr("A ball that is twice as wide is also twice as high and as deep: its "
                             "mass grows with r³."),
                own.radii, right.radii));
    if (isOff(p.density, good.density))
        found.push_back(
            say(is(p.density, 0.0) ? MassText::tr("The hits do not depend on the densities")
                : isPower(*p.density)
                    ? MassText::tr("The mass grows with the density to the power of %1, not %2")
                          .arg(brief(rounded(*p.density)), brief(rounded(*good.density)))
                    : MassText::tr("The masses do not follow the densities"),
                MassText::tr("Mass is density times volume, for each circle its own."),
                own.densities, right.densities));
    return found;
}

} // namespace cradle
