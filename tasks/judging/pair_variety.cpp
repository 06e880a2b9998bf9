// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_range.h"

#include "model/world/random.h"

#include <algorithm>

namespace cradle {

namespace {

/// Of so many digits that a reader can reckon with it.
double between(double low, double high, Random &random)
{
    return std::round(100.0 * random.between(low, high)) / 100.0;
}

/// Who comes how: each alone, one after the other, and both at once, also equally fast.
PairVelocities comingOf(int k, const Ground::Pair &asked, Random &random)
{
    const double closing = between(0.6, 1.6, random);
    const double other = between(0.2, 0.8, random);
    PairVelocities v{.along1 = closing};
    if (asked.bothMove) {
        switch (k % 6) {
        case 0:
            break;
        case 1:
            v = {.along2 = -closing};
            break;
        case 2: // exactly so, also when the line of centres has turned
            return {.along1 = 0.5 * closing, .along2 = -0.5 * closing};
        case 3:
            v = {.along1 = closing + other, .along2 = other};
            break;
        case 4:
            v = {.along1 = -other, .along2 = -other - closing};
            break;
        default: // clearly one faster than the other
            const double share = other < 0.5 ? other - 0.1 : other + 0.1;
            v = {.along1 = share * closing, .along2 = -(1.0 - share) * closing};
        }
    }
    // So oblique that they move to one side while the other is on another.
    const double slide =
        asked.oblique ? closing * between(0.25, 0.45, random) * (k % 4 < 2 ? 1.0 : -1.0) : 0.0;
    if (v.along1 == 0.0 || v.along2 == 0.0) {
        (v.along1 == 0.0 ? v.across2 : v.across1) = slide; // who rests does
        return v;
    }
    const double common = between(-0.9, 0.9, random);
    v.across1 = common + 0.5 * slide;
    v.across2 = common - 0.5 * slide;
    return v;
}

/// All ways of coming are among the fast ones, and among those with another e.
constexpr bool isFast(int k)
{
    return (k / 6 + k) % 2 == 1;
}

constexpr bool isLossy(int k)
{
    return k / 6 % 3 == 2;
}

/// What a number is tells nothing of any other, so what divides the hits is no chance; and from
/// this seed on all that MeetingDivision knows divides them in ways of its own.
constexpr int firstSeed = 1836;

/// The \p k-th of many kinds.
/// \param isSame  the circles are equal
Meeting variedMeeting(int k, const Ground::Pair &asked, bool isSame)
{
    Random random(firstSeed + k);
    const auto pairOf = [&](const Ground::Range &range, bool isEqual) {
        const double one = between(range.low, range.high, random);
        const double two = between(range.low, range.high, random);
        return range.isVaried() && !isEqual ? std::pair(one, two) : std::pair(one, one);
    };
    Meeting m;
    m.velocities = comingOf(k, asked, random);
    // Hardly to one side differs hardly from the other; some are exactly level, or upright. Who
    // comes in one way does so flat, steep and otherwise.
    const int slope = (k / 6 + k) % 3;
    const double off = std::round(10.0 + (slope == 0 ? 70.0 : 12.0) * random.uniform());
    m.degrees = 90.0 * static_cast<double>(random.below(4))
                + (k % 7 == 3   ? 0.0
                   : slope == 1 ? 90.0 - off
                                : off);
    // Of unequal ones some have the same radius, others the same density.
    std::tie(m.radius1, m.radius2) = pairOf(asked.radii, isSame || k % 7 == 2);
    std::tie(m.density1, m.density2) = pairOf(asked.densities, isSame || k % 7 < 2);
    const double far = 2.4 * asked.room;
    m.middle = {between(-far, far, random), 0.0};
    m.middle.y = between(-far, far, random);
    return m;
}

constexpr int meetings = 36;

} // namespace

std::vector<PairHit> PairRange::varied(double restitution) const
{
    constexpr int mostSteps = 40;
    std::vector<PairHit> hits;
    for (int k = 0; k < meetings; ++k) {
        Meeting m = variedMeeting(k, m_ground.pair, k % 5 == 0);
        m.restitution = restitution;
        const double way = m.closing() * m_h;
        hits.push_back(meet(m, m.sum() + 2.4 * way, m.sum(), m_h, mostSteps));
    }
    return hits;
}

PairHit PairRange::parted(Meeting meeting) const
{
    constexpr double deep = 0.4; // of r₁ + r₂: who asks for half of it answers them, too
    meeting.velocities = faster(meeting.velocities, -1.0);
    PairHit hit = meet(meeting, deep * meeting.sum(), deep * meeting.sum(), shortStep, 1);
    hit.parting = false;
    return hit;
}

PairHit PairRange::afar(Vec2 place, Vec2 velocity, Vec2 other, double radius) const
{
    PairHit hit{.slowness = m_paths.slowness(m_h)};
    hit.stage = {m_ground.stage(), true};
    std::vector<PresetCircle> &circles = hit.stage.preset.circles;
    circles[0].body = {place, hit.slowness * velocity, radius};
    circles[1].body = {other, -hit.slowness * velocity, radius};
    Probe probe(m_program, hit.stage);
    const std::vector<Circle> before = probe.world().circles;
    if (probe.runs() && probe.step())
        note(hit, before, probe, 1);
    return hit;
}

std::optional<PairHit> PairRange::opposite(double radius) const
{
    constexpr Vec2 place{-1.41, 0.83};
    constexpr Vec2 velocity{0.5, 0.3};
    const Vec2 other = 0.5 * radius * normalized(velocity) - place;
    // Whichever way is taken for their coming nearer.
    for (const Vec2 v : {velocity, -velocity}) {
        const PairHit hit = afar(place, v, other, radius);
        if (hit.answered && !afar(place, v, perpendicular(place), radius).answered)
            return hit;
    }
    return std::nullopt;
}

std::vector<PairHit> PairRange::answers() const
{
    const Ground::Pair &asked = m_ground.pair;
    const std::vector<double> &losses = asked.restitutions;
    const double greatest = *std::max_element(losses.begin(), losses.end());
    std::vector<PairHit> hits;
    for (int k = 0; k < meetings; ++k) {
        Meeting m = variedMeeting(k, asked, !asked.masses || k % 5 < 2);
        m.restitution = isLossy(k) ? losses[static_cast<std::size_t>(k) % losses.size()] : greatest;
        if (isFast(k))
            m.velocities = faster(m.velocities, 3.0);
        // In the second step of a run, or in the third: something may alternate.
        const double steps = (k / 4 + k) % 2 == 0 ? 1.4 : 2.4;
        const double way = m.closing() * shortStep;
        hits.push_back(meet(m, m.sum() + steps * way, m.sum(), shortStep, fewSteps));
    }
    return hits;
}

std::vector<PairHit> measurePairAnswers(const QString *program, const Ground &ground,
                                        const MeasuredFlight &flight)
{
    if (!program || !ground.pair.asked || ground.flights.size() < 2)
        return {};
    const PairRange range(program, ground, flight);
    return range.isKnown() ? range.answers() : std::vector<PairHit>{};
}

} // namespace cradle
