// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_pair.h"

#include "tasks/judging/likeness.h"
#include "tasks/judging/measured_wall.h"
#include "tasks/judging/pair_range.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

constexpr double slowly = 0.02;          ///< m/s, less than in the slowest check
constexpr double leastRestitution = 0.2; ///< with less, circle 2 stays with the other

/// The velocities of the meetings that a step asks about. Where both may move, both do: that of a
/// circle at rest could be lost unseen.
std::vector<PairVelocities> throws(const Ground::Pair &pair)
{
    if (!pair.oblique)
        return pair.bothMove
                   ? std::vector<PairVelocities>{{1.2, 0.4, 0.1, 0.4},
                                                 {-0.1, -0.3, -1.2, -0.3},
                                                 {1.7, 0.2, 0.5, 0.2},
                                                 {-0.5, 0.3, -1.7, 0.3}}
                   : std::vector<PairVelocities>{{1.2, 0.0, 0.0, 0.0}, {1.9, 0.0, 0.0, 0.0}};
    // Not so oblique that they miss each other where a program asks for half the distance.
    if (!pair.bothMove)
        return {{1.2, 0.0, 0.0, 0.0}, {1.2, 0.4, 0.0, 0.0}, {1.5, -0.5, 0.0, 0.0}};
    return {{1.2, 0.2, 0.1, -0.1}, {-0.1, 0.1, -1.2, 0.3}, {1.2, 0.5, -0.3, 0.1},
            {1.2, 0.1, 0.2, 0.4},  {1.7, 0.3, 0.5, -0.1},  {-0.5, 0.2, -1.7, 0.5}};
}

/// That who comes late is seen to come.
PairVelocities gentleThrow(const Ground::Pair &asked)
{
    PairVelocities gentle =
        asked.bothMove ? PairVelocities{0.7, 0.1, -0.5, 0.1} : PairVelocities{1.2, 0.0, 0.0, 0.0};
    if (asked.oblique)
        gentle.across1 = 0.25;
    return gentle;
}

/// Lines of centres, degrees from the x axis, and where they meet, m.
constexpr std::array aroundAndAbout{
    std::pair{3.0, Vec2{0.17, -0.23}},  std::pair{47.0, Vec2{1.7, 1.6}},
    std::pair{88.0, Vec2{-1.8, 0.9}},   std::pair{131.0, Vec2{0.9, -1.7}},
    std::pair{222.0, Vec2{-1.6, -1.5}}, std::pair{318.0, Vec2{2.3, 2.3}}};

/// Of two digits, so that a reader can reckon with them.
double within(const Ground::Range &r, double share)
{
    const double value = r.low + share * (r.high - r.low);
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return r.isVaried() ? std::round(value / digit) * digit : value;
}

/// Of hits by the same circles: one that comes far deeper than another along the same line.
void noteLate(std::vector<PairHit> &hits)
{
    for (PairHit &hit : hits) {
        hit.late = hit.answered && std::any_of(hits.begin(), hits.end(), [&](const PairHit &other) {
                       return other.isMet() && other.meeting.degrees == hit.meeting.degrees
                              && hit.before < 0.5 * other.reached;
                   });
    }
}

/// Head-on and exactly level or upright, from all four sides; where both may come, circle 2 alone
/// does so, too: a sign or a part that a program confuses shows where it is all that there is.
/// Without those whose push is little just beside that line: there it may be none.
std::vector<PairHit> alongAxes(const PairRange &range, Meeting meeting, double restitution,
                               bool bothMove)
{
    constexpr double speed = 1.2;  // m/s
    constexpr double beside = 4.0; // degrees
    meeting.restitution = restitution;
    std::vector<PairHit> hits;
    const auto isWeak = [](const PairHit &hit) {
        return hit.isMet() && length(hit.push1()) + length(hit.push2()) < 0.5 * speed;
    };
    const auto add = [&](double degrees, const PairVelocities &velocities) {
        meeting.velocities = velocities;
        meeting.degrees = degrees;
        hits.push_back(range.look(meeting));
        meeting.degrees += beside;
        if (!hits.back().isInTime() && isWeak(range.look(meeting)))
            hits.pop_back();
    };
    for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
        add(degrees, {.along1 = speed});
        if (bothMove)
            add(degrees, {.along2 = -speed});
    }
    return hits;
}

} // namespace

Meeting equalMeeting(const Ground::Pair &asked)
{
    const double radius = within(asked.radii, 0.3);
    const double density = within(asked.densities, 0.25);
    return {33.0,
            radius,
            radius,
            density,
            density,
            middleOf(asked.restitutions),
            throws(asked).front()};
}

MeasuredPair::MeasuredPair(const QString *program, const Ground &ground,
                           const MeasuredFlight &flight)
{
    const Ground::Pair &asked = ground.pair;
    if (!asked.asked || ground.flights.size() < 2)
        return;
    const PairRange range(program, ground, flight);
    isJudged = range.isKnown();
    if (!isJudged)
        return;
    const double small = within(asked.radii, 0.3);
    const double large = within(asked.radii, 0.75);
    // Of another size than both, or a number could be taken for the larger of two.
    const double largest = within(asked.radii, 0.9);
    const double light = within(asked.densities, 0.25);
    const double dense = within(asked.densities, 0.8);
    const double e = *std::max_element(asked.restitutions.begin(), asked.restitutions.end());
    const PairVelocities gentle = gentleThrow(asked);
    for (const auto &[degrees, middle] : aroundAndAbout) {
        Meeting m{degrees, small, large, light, light, e, gentle, asked.room * middle};
        // A circle at rest is met, too.
        if (asked.bothMove && degrees == 131.0)
            m.velocities = {1.2, gentle.across1, 0.0, 0.0};
        if (asked.bothMove && degrees == 222.0)
            m.velocities = {0.0, 0.0, -1.2, gentle.across1};
        contacts.push_back(range.scan(m));
    }
    if (asked.radii.isVaried()) {
        for (const double degrees : {33.0, 205.0})
            contacts.push_back(range.scan({degrees, large, small, light, light, e, gentle}));
        contacts.push_back(range.scan({111.0, largest, largest, light, light, e, gentle}));
    }
    const bool isOff = std::any_of(contacts.begin(), contacts.end(), [](const PairHit &hit) {
        return hit.isMet() && !hit.fits(hit.meeting.sum());
    });
    if (isOff && !asked.radii.isVaried()) {
        const PairVelocities slower = faster(gentle, 0.4);
        for (const auto &[one, two] : {std::pair(0.14, 0.36), std::pair(0.36, 0.14)}) {
            for (const double degrees : {33.0, 205.0})
                otherRadii.push_back(range.scan({degrees, one, two, light, light, e, slower}));
        }
    }
    const std::vector<PairVelocities> all = throws(asked);
    for (const double degrees : {33.0, 118.0}) {
        for (const PairVelocities &v : all)
            equals.push_back(range.look({degrees, small, small, light, light, e, v}));
    }
    noteLate(equals);
    modes = {equals.begin(), equals.begin() + static_cast<std::ptrdiff_t>(all.size())};
    const PairVelocities &both = all.size() > 4 ? all[4] : all.back();
    if (asked.radii.isVaried() && asked.masses) {
        radii.push_back(range.look({33.0, small, large, light, light, e, both}));
        radii.push_back(range.look({33.0, large, small, light, light, e, both}));
        radii.push_back(range.look({61.0, large, large, light, light, e, both}));
    } else {
        larger = range.look({61.0, 1.4 * small, 1.4 * small, light, light, e, both});
        if (asked.radii.isVaried())
            sizes = {range.look({33.0, small, large, light, light, e, both}),
                     range.look({33.0, large, small, light, light, e, both})};
    }
    if (asked.densities.isVaried() && asked.masses) {
        densities.push_back(range.look({33.0, small, small, light, dense, e, both}));
        densities.push_back(range.look({33.0, small, small, dense, light, e, both}));
        densities.push_back(range.look({33.0, small, small, dense, dense, e, both}));
        if (asked.restitutions.size() > 1)
            densities.push_back(range.look({33.0, small, small, light, dense, 0.5 * e, both}));
    }
    for (const double other : asked.restitutions) {
        if (other != e)
            rebounds.push_back(range.look({33.0, small, small, light, light, other, both}));
    }
    for (const double degrees : {21.0, 143.0}) {
        PairVelocities apart{-0.9, 0.4, 0.8, 0.4};
        partings.push_back(range.part({degrees, small, small, light, light, e, apart}));
    }
    const auto missesNone = [](const std::vector<PairHit> *hits) {
        return std::all_of(hits->begin(), hits->end(),
                           [](const PairHit &hit) { return hit.isInTime(); });
    };
    std::vector<PairHit> axes = alongAxes(range, equalMeeting(asked), e, asked.bothMove);
    const auto usual = {&contacts, &equals, &radii, &densities, &axes};
    if (!std::all_of(usual.begin(), usual.end(), missesNone)) {
        varied = range.varied(e);
        opposite = range.opposite(small);
    }
    areOfParting = answersPartingsAlone();
    if (areOfParting) {
        for (auto *hits : {&equals, &radii, &sizes, &densities, &rebounds}) {
            for (PairHit &hit : *hits)
                hit = range.parted(hit.meeting);
        }
    }
    // What is said of a program that stopped is its error.
    const auto stopped = [](const PairHit &hit) { return hit.stopped; };
    for (const auto *hits : {&contacts, &equals, &radii, &sizes, &densities, &rebounds})
        isJudged = isJudged && std::none_of(hits->begin(), hits->end(), stopped);
    if (range.isUsual()) {
        own = range.own();
        if (own && std::abs(own->rebound() - own->meeting.restitution) > 0.05)
            ownTurned = range.ownTurned(*own);
        inSteps = range.inSteps(equalMeeting(asked), e);
        spread = range.spread(inSteps.front());
    }
    range.meetAgain(*this);
    // Small enough to tell e from what it was multiplied with.
    const auto &others = asked.restitutions;
    const auto middle = std::find(others.begin(), others.end(), 0.5);
    const double some = middle == others.end() ? e : *middle;
    const double second = asked.bothMove ? -0.4 * slowly : 0.0;
    slow = range.look(
        {33.0, small, small, light, light, some, {.along1 = second + slowly, .along2 = second}});
    fast = range.approach({33.0, small, small, light, light, some, faster(gentle, 3.5)});
    // As fast, by one alone: a program may ask for the speed of one.
    const double closing = 3.5 * (gentle.along1 - gentle.along2);
    for (const PairVelocities &alone :
         {PairVelocities{.along1 = closing}, PairVelocities{.along2 = -closing}}) {
        PairHit hit = asked.bothMove && fast->isMet()
                          ? range.approach({33.0, small, small, light, light, some, alone})
                          : *fast;
        if (!hit.isMet())
            fast = std::move(hit);
    }
    twice = range.twice({33.0, small, small, light, light, some, gentle});
    // One that is not answered is looked at from near, where words point to a step of it.
    if (!slow->answered)
        slow = range.approach(slow->meeting);
    if (asked.oblique && asked.bothMove && range.isUsual() && some >= leastRestitution)
        later = range.later(small, light, some);
}

bool MeasuredPair::answersPartingsAlone() const
{
    const auto isMet = [](const PairHit &hit) { return hit.isMet(); };
    const auto answered = [](const PairHit &hit) { return hit.answered && hit.step == 1; };
    return std::none_of(contacts.begin(), contacts.end(), isMet)
           && std::none_of(equals.begin(), equals.end(), isMet)
           && std::none_of(varied.begin(), varied.end(), isMet)
           && std::all_of(partings.begin(), partings.end(), answered);
}

bool arePushedAlong(const MeasuredPair &pair)
{
    return std::none_of(pair.equals.begin(), pair.equals.end(),
                        [](const PairHit &hit) { return hit.isInTime() && !hit.isAlongCentres(); });
}

} // namespace cradle
