// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_reading.h"

#include <QCoreApplication>

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

double rounded(double p)
{
    return std::round(p * 50.0) / 50.0;
}

LawDeviation say(const QString &headline, const QString &why, const std::vector<PairHit> &hits,
                 const std::vector<PairHit> &right)
{
    const PairHit &hit = hits.front();
    const Meeting &m = hit.meeting;
    const QString what =
        MassText::tr(
            "With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4, the hit changed the velocity "
            "of circle 1 %5 times as much as that of circle 2; m₂/m₁ = %6 is right.")
            .arg(brief(m.radius1), brief(m.radius2), brief(m.density1), brief(m.density2),
                 brief(massRatio(hit).value_or(0.0)),
                 brief(massRatio(right.front()).value_or(0.0)));
    return responseDeviation(headline, what + QLatin1Char(' ') + why, hit);
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
    if (const auto ratio = fixedMassRatio(own))
        return {responseDeviation(
            MassText::tr("The masses are numbers, not those of the circles"),
            MassText::tr("Two circles of the same radius and density answer as if circle 2 were "
                         "%1 times as heavy as circle 1. Work the masses out from `radius` and "
                         "`density`, which other scenes change.")
                .arg(brief(*ratio)),
            own.equals.front())};
    MassExponents p(own);
    const MassExponents good(right);
    const auto isOff = [](const std::optional<double> &a, const std::optional<double> &b) {
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
        found.push_back(say(MassText::tr("Each circle answers with the mass of the other"),
                            MassText::tr("The heavier one is pushed away faster. Look at which "
                                         "mass stands where."),
                            own.radii, right.radii));
        p.radius = -*p.radius;
        if (p.density)
            p.density = -*p.density;
    }
    if (isOff(p.radius, good.radius))
        found.push_back(say(
            is(p.radius, 0.0) ? MassText::tr("The radius is left out of the mass")
                              : MassText::tr("The mass grows with r to the power of %1, not %2")
                                    .arg(brief(rounded(*p.radius)), brief(rounded(*good.radius))),
            MassText::tr("A ball that is twice as wide is also twice as high and as deep: its "
                         "mass grows with r³."),
            own.radii, right.radii));
    if (isOff(p.density, good.density))
        found.push_back(
            say(is(p.density, 0.0)
                    ? MassText::tr("The density is left out of the mass")
                    : MassText::tr("The mass grows with the density to the power of %1, not %2")
                          .arg(brief(rounded(*p.density)), brief(rounded(*good.density))),
                MassText::tr("Mass is density times volume."), own.densities, right.densities));
    return found;
}

} // namespace cradle
