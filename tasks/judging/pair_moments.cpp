// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/pair_range.h"

#include <numbers>

namespace cradle {

namespace {

constexpr double commonSpeed = 3.0; ///< m/s
constexpr double closingSpeed = 0.3;

} // namespace

std::vector<PairHit> PairRange::chases() const
{
    constexpr int mostSteps = 60;
    std::vector<PairHit> hits;
    const double way = commonSpeed * m_h;
    for (const double sign : {1.0, -1.0}) {
        Meeting m = equalMeeting(m_ground.pair);
        m.velocities = {.along1 = sign * commonSpeed + 0.5 * closingSpeed,
                        .along2 = sign * commonSpeed - 0.5 * closingSpeed};
        const double angle = m.degrees * std::numbers::pi / 180.0;
        m.middle = -0.7 * sign * Vec2{std::cos(angle), std::sin(angle)};
        hits.push_back(meet(m, m.sum() + 1.8 * way, m.sum(), m_h, mostSteps));
    }
    return hits;
}

std::optional<PairHit> PairRange::ownTurned(const PairHit &own) const
{
    constexpr double turn = 0.6; // rad
    constexpr int mostSteps = 60;
    const auto turned = [](Vec2 v) {
        return Vec2{std::cos(turn) * v.x - std::sin(turn) * v.y,
                    std::sin(turn) * v.x + std::cos(turn) * v.y};
    };
    PairHit hit{.meeting = own.meeting, .stage = own.stage};
    Probe probe(m_program, hit.stage);
    if (!probe.runs())
        return std::nullopt;
    const Preset &scene = probe.start();
    const Vec2 n = turned(own.normal);
    World world = probe.world();
    const double apart = own.meeting.sum() + 2.5 * scene.timestep * own.meeting.closing();
    for (const int i : {0, 1}) {
        Circle &c = world.circles[static_cast<std::size_t>(i)];
        c.position = own.meeting.middle + (i == 0 ? -0.5 : 0.5) * apart * n;
        c.velocity = turned(i == 0 ? own.came1 : own.came2);
    }
    probe.place(world);
    for (int k = 1; k <= mostSteps && !hit.answered; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (isNearWall(before[0]) || isNearWall(before[1]) || !probe.step())
            return std::nullopt;
        note(hit, before, probe, k, scene.gravity);
    }
    return hit.answered ? std::optional(hit) : std::nullopt;
}

std::vector<PairHit> measurePairChases(const QString *program, const Ground &ground,
                                       const MeasuredFlight &flight)
{
    if (!program || !ground.pair.bothMove || ground.flights.size() < 2)
        return {};
    const PairRange range(program, ground, flight);
    return range.isKnown() && range.isEven() ? range.chases() : std::vector<PairHit>{};
}

std::optional<LawDeviation> momentsDeviation(const std::vector<PairHit> &chases)
{
    if (chases.size() != 2 || !chases[0].isMet() || !chases[1].isMet())
        return std::nullopt;
    const double sum = chases[0].meeting.sum();
    const double way = commonSpeed * chases[0].stage.preset.timestep;
    const double ahead = 0.5 * (chases[0].before + chases[0].reached) - sum;
    const double behind = 0.5 * (chases[1].before + chases[1].reached) - sum;
    // The way of one step more for one direction, and less for the other.
    const double blur = 0.3 * way;
    if (std::abs(ahead + behind) > blur || std::abs(std::abs(ahead) - way) > blur)
        return std::nullopt;
    const PairHit &late = ahead < behind ? chases[0] : chases[1];
    return LawDeviation{
        .aspect = Aspect::Contact,
        .message =
            ContactText::tr("The distance is taken between places of two moments\n\nBoth circles "
                            "flew with %1 m/s along the line of centres, the one behind %2 m/s "
                            "faster: where circle 2 was ahead, they answered with the centres %3 m "
                            "apart, where circle 1 was, %4 m; rims touch at %5 m. The two differ "
                            "from that by what a circle flies in a step: look at whether both "
                            "places are of the same moment, after both have moved.")
                .arg(brief(commonSpeed), brief(closingSpeed), brief(sum + ahead),
                     brief(sum + behind), brief(sum)),
        .moment = {.stage = late.stage, .step = late.step, .circles = {0, 1}},
        .suspect = Suspect::Reach,
        .topic = Topic::Distance,
        .isConditional = true};
}

} // namespace cradle
