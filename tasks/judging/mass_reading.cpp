// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double antiparallel = 0.02; ///< of the directions of two pushes

/// Whether two masses may have it: who gets all or nothing is not a million times as light or
/// heavy.
bool isShare(double share)
{
    constexpr double least = 1e-6;
    return share > least && share < 1.0 - least;
}

/// The exponent in mass ∝ q^p that all \p hits agree in; \p ratio gives q₂ / q₁.
template <class Ratio>
std::optional<double> exponentOf(const std::vector<PairHit> &hits, std::optional<int> circle,
                                 Ratio ratio)
{
    std::optional<double> exponent;
    for (const PairHit &hit : hits) {
        const double q = ratio(hit.meeting);
        if (std::abs(q - 1.0) < 1e-9)
            continue;
        const auto heavy = circle ? massRatioFor(hit, *circle) : massRatio(hit);
        if (!heavy)
            return std::nullopt;
        const double p = std::log(*heavy) / std::log(q);
        if (exponent && std::abs(*exponent - p) > 3.0 * ratioBlur * (1.0 + std::abs(p)))
            return std::nullopt;
        exponent = p;
    }
    return exponent;
}

} // namespace

double roundedExponent(double p)
{
    return std::round(p * 50.0) / 50.0;
}

bool isHeadOn(const PairHit &hit)
{
    const PairVelocities in = hit.cameParts();
    return std::abs(in.across1) + std::abs(in.across2)
           < 1e-9 * (std::abs(in.along1) + std::abs(in.along2));
}

bool isOnePushed(const PairHit &hit)
{
    return hit.isMet() && std::min(length(hit.push1()), length(hit.push2())) < 1e-6;
}

std::optional<double> massRatio(const PairHit &hit)
{
    const double p1 = length(hit.push1());
    const double p2 = length(hit.push2());
    if (!hit.isMet() || std::max(p1, p2) < 1e-6)
        return std::nullopt;
    if (isOnePushed(hit)) {
        // What one gets of (1 + e) u is the share of the other in both masses.
        const Vec2 n = normalized(hit.push2() - hit.push1());
        const double u = dot(hit.came1 - hit.came2, n);
        const double share = std::max(p1, p2) / ((1.0 + hit.meeting.restitution) * u);
        const double heavy = share / (1.0 - share);
        return isShare(share) ? std::optional(p1 > p2 ? heavy : 1.0 / heavy) : std::nullopt;
    }
    const Vec2 sum = hit.push1() / p1 + hit.push2() / p2;
    return length(sum) < antiparallel ? std::optional(p1 / p2) : std::nullopt;
}

std::optional<double> massRatioFor(const PairHit &hit, int circle)
{
    if (!hit.isMet() || !hit.isAligned())
        return std::nullopt;
    const PairVelocities in = hit.cameParts();
    const PairVelocities out = hit.leftParts();
    const double push = circle == 0 ? in.along1 - out.along1 : out.along2 - in.along2;
    const double share = push / ((1.0 + hit.meeting.restitution) * (in.along1 - in.along2));
    if (!isShare(share))
        return std::nullopt;
    return circle == 0 ? share / (1.0 - share) : (1.0 - share) / share;
}

MassExponents::MassExponents(const MeasuredPair &pair, std::optional<int> circle)
    : radius(exponentOf(pair.radii, circle, [](const Meeting &m) { return m.radius2 / m.radius1; }))
    , density(exponentOf(pair.densities, circle,
                         [](const Meeting &m) { return m.density2 / m.density1; }))
{
}

double MassExponents::ratioOf(const Meeting &m) const
{
    return std::pow(m.radius2 / m.radius1, roundedExponent(radius.value_or(3.0)))
           * std::pow(m.density2 / m.density1, roundedExponent(density.value_or(1.0)));
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

} // namespace cradle
