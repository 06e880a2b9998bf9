// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cradle {

namespace {

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

} // namespace

std::optional<LawDeviation> numberedMasses(const MeasuredPair &own)
{
    const auto ratio = fixedMassRatio(own);
    if (!ratio)
        return std::nullopt;
    const auto say = [&](const QString &headline, const QString &body) {
        LawDeviation found = responseDeviation(headline, body, own.equals.front(), Suspect::Masses);
        found.isOfSome = true;
        return found;
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
    if (const PairHit *other = otherRatioIn(own.densities, *ratio))
        return say(twoWays,
                   ResponseText::tr(
                       "Two circles of the same radius and density answer as if circle 2 were "
                       "%1 times as heavy as circle 1, and with ρ₁ = %2 and ρ₂ = %3 as if it "
                       "were %4 times. Compare the lines for the two masses.")
                       .arg(brief(*ratio), brief(other->meeting.density1),
                            brief(other->meeting.density2),
                            brief(massRatio(*other).value_or(0.0))));
    return say(
        ResponseText::tr("The two masses have the same ratio in all hits tried"),
        ResponseText::tr("Of whatever size and density the two are, they answer as if circle 2 "
                         "were %1 times as heavy as circle 1. Work each mass out from the `radius` "
                         "and `density` of its own circle, which other scenes change.")
            .arg(brief(*ratio)));
}

namespace {

/// How much faster, m/s, a hit makes two circles part; < 0: come nearer.
double partedBy(const PairHit &hit)
{
    return dot(hit.push2() - hit.push1(), hit.normal);
}

/// Of what parts two circles, (1 + e) u, what the velocities of both change by, together.
std::optional<double> sharedPart(const PairHit &hit)
{
    if (!massRatio(hit) || isOnePushed(hit) || !hit.isAligned())
        return std::nullopt;
    const PairVelocities in = hit.cameParts();
    const double parted = std::copysign(length(hit.push1()) + length(hit.push2()), partedBy(hit));
    return parted / ((1.0 + hit.meeting.restitution) * (in.along1 - in.along2));
}

} // namespace

bool isUnshared(const PairHit &hit)
{
    const auto part = sharedPart(hit);
    return part && std::abs(*part - 1.0) > 2e-3;
}

const PairHit *unsharedHit(const MeasuredPair &own)
{
    constexpr double blur = 0.02;
    const std::array lists{&own.equals, &own.radii, &own.densities};
    // What e makes of the rebound is another matter, so both are of the same e.
    std::map<double, double> ofAlike;
    for (const std::vector<PairHit> *hits : lists) {
        for (const PairHit &hit : *hits) {
            const Meeting &m = hit.meeting;
            if (const auto part = sharedPart(hit);
                part && m.radius1 == m.radius2 && m.density1 == m.density2)
                ofAlike.try_emplace(m.restitution, *part);
        }
    }
    const auto isOther = [&](const PairHit &hit) {
        const auto same = ofAlike.find(hit.meeting.restitution);
        const auto part = sharedPart(hit);
        return part && same != ofAlike.end() && std::abs(*part / same->second - 1.0) > blur;
    };
    for (const std::vector<PairHit> *hits : lists) {
        const auto found = std::find_if(hits->begin(), hits->end(), isOther);
        if (found != hits->end())
            return &*found;
    }
    return nullptr;
}

namespace {

/// That both pushes have the wrong sign, where \p right, m/s, is what they should change together.
QString drivenTogether(const PairHit &hit, double right)
{
    const auto along = [&](Vec2 push) { return brief(dot(push, hit.normal)); };
    return ResponseText::tr("Along it, from 1 to 2, the velocity of circle 1 changed by %1 m/s and "
                            "that of circle 2 by %2 m/s, so that they come nearer still faster. A "
                            "hit takes (1 + e) u = %3 m/s of that, and each circle changes by its "
                            "share: circle 1 by m₂/(m₁ + m₂) and circle 2 by m₁/(m₁ + m₂) of it.")
        .arg(along(hit.push1()), along(hit.push2()), brief(right));
}

} // namespace

LawDeviation unsharedDeviation(const PairHit &hit)
{
    const Meeting &m = hit.meeting;
    const double closing = hit.cameParts().along1 - hit.cameParts().along2;
    const double right = (1.0 + m.restitution) * closing;
    const double push1 = length(hit.push1());
    const double push2 = length(hit.push2());
    const QString scene =
        ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %5) they came "
                         "nearer with u = %6 m/s along the line of centres.")
            .arg(brief(m.radius1), brief(m.radius2), brief(m.density1), brief(m.density2),
                 brief(m.restitution), brief(closing));
    const QString change =
        ResponseText::tr("Circle 1 changed its velocity by %1 m/s and circle 2 by %2, together %3 "
                         "m/s; (1 + e) u = %4 m/s is right. However heavy they are, the share of "
                         "circle 1 is m₂/(m₁ + m₂) and that of circle 2 m₁/(m₁ + m₂).")
            .arg(brief(push1), brief(push2), briefBeside(push1 + push2, right),
                 briefBeside(right, push1 + push2));
    const bool isTogether = partedBy(hit) < 0.0;
    LawDeviation found = responseDeviation(
        isTogether ? ResponseText::tr("Some hits drive the circles towards each other")
                   : ResponseText::tr("The shares of the two circles do not add up to 1"),
        scene + QLatin1Char(' ') + (isTogether ? drivenTogether(hit, right) : change), hit,
        Suspect::Formula);
    found.topic = Topic::Shares;
    return found;
}

} // namespace cradle
