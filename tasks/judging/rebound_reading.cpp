// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_reading.h"

#include "tasks/judging/rebound_laws.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

Rebound reboundOf(const PairHit &hit, double heavy)
{
    if (!hit.isMet())
        return {.e = hit.meeting.restitution, .first = -1.0, .second = -1.0};
    const PairVelocities in = hit.cameParts();
    const PairVelocities out = hit.leftParts();
    const double u = in.along1 - in.along2;
    return {.e = hit.meeting.restitution,
            .first = (1.0 + heavy) / heavy * (in.along1 - out.along1) / u - 1.0,
            .second = (1.0 + heavy) * (out.along2 - in.along2) / u - 1.0,
            .across1 = out.across1 / in.across1,
            .across2 = out.across2 / in.across2,
            .sum = (out.along1 + out.along2) / (in.along1 + in.along2)};
}

bool followEach(const std::vector<Rebound> &all, double Rebound::*part, const LawOfE &law)
{
    return std::all_of(all.begin(), all.end(), [&](const Rebound &r) {
        const double wanted = law(r.e);
        return !std::isfinite(wanted) || std::abs(r.*part - wanted) < reboundBlur;
    });
}

bool isOfMasses(const LawOfE &law, int circle, const MeasuredPair &own, const MeasuredPair &right)
{
    const auto holds = [&](const std::vector<PairHit> &mine, const std::vector<PairHit> &theirs) {
        for (std::size_t i = 0; i < mine.size(); ++i) {
            if (!mine[i].isMet() || !theirs[i].isMet() || !mine[i].isAligned()
                || !theirs[i].isAligned())
                continue;
            const double e = mine[i].meeting.restitution;
            const PairVelocities in = mine[i].cameParts();
            const PairVelocities out = mine[i].leftParts();
            const PairVelocities good = theirs[i].leftParts();
            const double push = circle == 1 ? out.along1 - in.along1 : out.along2 - in.along2;
            const double asked = circle == 1 ? good.along1 - in.along1 : good.along2 - in.along2;
            if (std::abs(push - asked * (1.0 + law(e)) / (1.0 + e))
                > reboundBlur * (1.0 + std::abs(asked)))
                return false;
        }
        return true;
    };
    return holds(own.radii, right.radii) && holds(own.densities, right.densities);
}

namespace {

/// Whether unequal circles, too, part as \p law tells of e, whatever masses share the push.
bool partBy(const LawOfE &law, const MeasuredPair &own)
{
    for (const auto *hits : {&own.radii, &own.densities}) {
        for (const PairHit &hit : *hits) {
            if (hit.isMet() && hit.isAligned()
                && (!massRatio(hit)
                    || std::abs(hit.rebound() - law(hit.meeting.restitution)) > reboundBlur))
                return false;
        }
    }
    return true;
}

} // namespace

std::optional<PushLine> lineOfPush(const MeasuredPair &own, const std::vector<Rebound> &all,
                                   const std::vector<Rebound> &elastic)
{
    constexpr double clear = 2.0 * reboundBlur;
    if (all.size() < 2 || elastic.empty())
        return std::nullopt;
    const Rebound &some = all.front();
    const Rebound &most = elastic.front();
    const double perE = (most.first - some.first) / (most.e - some.e);
    const double without = 1.0 + most.first - perE * most.e;
    const LawOfE law = [=](double e) { return without + perE * e - 1.0; };
    if (std::abs(without - perE) < clear || std::abs(perE) < clear || without < clear)
        return std::nullopt;
    for (const auto *each : {&all, &elastic}) {
        for (const auto part : {&Rebound::first, &Rebound::second}) {
            if (!followEach(*each, part, law))
                return std::nullopt;
        }
    }
    return partBy(law, own) ? std::optional(PushLine{without, perE}) : std::nullopt;
}

QString faintPush(const PairHit &hit)
{
    constexpr double faint = 0.01; // of the speed with which they come nearer
    const PairVelocities in = hit.cameParts();
    const auto isFaint = [&](Vec2 push) {
        return length(push) > 1e-9 && length(push) < faint * std::abs(in.along1 - in.along2);
    };
    return isFaint(hit.push1()) && isFaint(hit.push2())
               ? ReboundText::tr(
                     "The hit changed the velocity of circle 1 by no more than %1 m/s and "
                     "that of circle 2 by %2 m/s: look at what the push is multiplied "
                     "by, and what it is divided by.")
                     .arg(brief(length(hit.push1())), brief(length(hit.push2())))
               : QString();
}

} // namespace cradle
