// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_range.h"

#include <algorithm>

namespace cradle {

namespace {

/// The \p k-th of numbers that fill the range from 0 to 1 evenly, for each \p quantity others.
double spread(int k, int quantity)
{
    constexpr double primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41};
    const double all = (k + 1) * std::sqrt(primes[quantity]);
    return all - std::floor(all);
}

/// Of so many digits that a reader can reckon with it.
double between(double low, double high, double share)
{
    return std::round(100.0 * (low + share * (high - low))) / 100.0;
}

/// Who comes how: each alone, one after the other, and both at once, also equally fast.
PairVelocities comingOf(int k, const Ground::Pair &asked)
{
    const double closing = between(0.6, 1.6, spread(k, 0));
    const double other = between(0.2, 0.8, spread(k, 1));
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
        default:
            v = {.along1 = other * closing, .along2 = -(1.0 - other) * closing};
        }
    }
    // So oblique that they move to one side while the other is on another.
    const double slide =
        asked.oblique ? closing * between(0.25, 0.45, spread(k, 3)) * (k % 4 < 2 ? 1.0 : -1.0)
                      : 0.0;
    if (v.along1 == 0.0 || v.along2 == 0.0) {
        (v.along1 == 0.0 ? v.across2 : v.across1) = slide; // who rests does
        return v;
    }
    const double common = between(-0.9, 0.9, spread(k, 2));
    v.across1 = common + 0.5 * slide;
    v.across2 = common - 0.5 * slide;
    return v;
}

/// All ways of coming are among the fast ones, and among those with another e; so are all sides,
/// which come round again after 12.
constexpr bool isFast(int k)
{
    return (k / 6 + k) % 2 == 1;
}

constexpr bool isLossy(int k)
{
    return k / 6 % 3 == 2;
}

/// The \p k-th of many kinds.
/// \param isSame  the circles are equal
Meeting variedMeeting(int k, const Ground::Pair &asked, bool isSame)
{
    const auto pairOf = [](const Ground::Range &range, int n, int quantity, bool isEqual) {
        const double one = between(range.low, range.high, spread(n, quantity));
        const double two = between(range.low, range.high, spread(n, quantity + 1));
        return range.isVaried() && !isEqual ? std::pair(one, two) : std::pair(one, one);
    };
    Meeting m;
    // Hardly to one side differs hardly from the other; some are exactly level, or upright.
    const double off = std::round(10.0 + (k % 3 == 0 ? 70.0 : 12.0) * spread(k, 4));
    m.degrees = 90.0 * std::floor(4.0 * spread(k, 11))
                + (k % 9 == 4   ? 0.0
                   : k % 3 == 1 ? 90.0 - off
                                : off);
    std::tie(m.radius1, m.radius2) = pairOf(asked.radii, k, 5, isSame);
    std::tie(m.density1, m.density2) = pairOf(asked.densities, k, 7, isSame || k % 7 < 2);
    m.velocities = comingOf(k, asked);
    const double far = 2.4 * asked.room;
    m.middle = {between(-far, far, spread(k, 9)), between(-far, far, spread(k, 10))};
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
    PairHit hit{.slowness = slowness(m_h)};
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
