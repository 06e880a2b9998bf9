// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_pair.h"

#include "tasks/judging/likeness.h"

#include <algorithm>
#include <array>
#include <map>

namespace cradle {

namespace {

constexpr double kick = 1e-6;      ///< of a velocity, relative: what no rounding makes
constexpr double shortStep = 1e-4; ///< s, so that the line of centres hardly turns in a step
constexpr double hitBlur = 4e-3;   ///< of velocities after a hit in such a step, relative
constexpr int fewSteps = 8;
constexpr double secondsOfOwn = 6.0;

/// Throws circles at each other and looks.
class PairRange
{
public:
    PairRange(const QString *program, const Ground &ground, const MeasuredFlight &flight)
        : m_program(program)
        , m_ground(ground)
        , m_flight(flight)
        , m_h(ground.timesteps.empty() ? 1.0 / 60.0 : ground.timesteps.front())
    {
    }

    /// Whether both circles go as far as their velocities, one as the other.
    [[nodiscard]] bool isKnown() const
    {
        for (const double h : {m_h, shortStep}) {
            const auto &flights = m_flight.at({}, h);
            for (const Flight &f : {flights[0], flights[1]}) {
                if (!f.isKnown || f.way.x <= 0.0 || !isAlike(f.way.x, f.way.y)
                    || !isAlike(f.way.x, flights[0].way.x)
                    || length(f.drift) > 0.1 * f.way.x * h * slowness(h))
                    return false;
            }
        }
        return true;
    }

    /// Whether they go as far as they should, so that the own scene can be read.
    [[nodiscard]] bool isUsual() const { return isAlike(slowness(m_h), 1.0, 0.05); }

    /// Comes from far in steps of the usual length.
    [[nodiscard]] PairHit scan(const Meeting &meeting) const
    {
        return meet(meeting, 2.2137 * meeting.sum(), meeting.sum(), m_h);
    }

    /// The same in so short steps that the answer can be read exactly.
    [[nodiscard]] PairHit look(const Meeting &meeting) const
    {
        const double way = std::abs(meeting.closing()) * shortStep;
        const std::array key{meeting.radius1, meeting.radius2, meeting.degrees};
        const auto seen = m_seen.find(key);
        const double guess = seen == m_seen.end() ? meeting.sum() : seen->second;
        const PairHit hit = meet(meeting, guess + 2.4 * way, guess, shortStep, fewSteps);
        if (hit.answered && hit.step > 1)
            return hit;
        // It is not where it should be: where it is, scan() knows to a step.
        const PairHit coarse = scan(meeting);
        // Who answers too late may let them pass each other, but not when they come straight.
        const PairHit found = coarse.answered ? coarse : scan(straight(meeting));
        if (!found.answered)
            return coarse;
        const PairHit fine =
            meet(meeting, found.before + way, 0.5 * (found.before + found.reached), shortStep);
        if (!fine.answered)
            return coarse;
        // Once more, so that they stand along the same line when they are answered.
        m_seen[key] = 0.5 * (fine.before + fine.reached);
        const PairHit exact =
            meet(meeting, m_seen[key] + 2.4 * way, m_seen[key], shortStep, fewSteps);
        return exact.answered ? exact : fine;
    }

    static Meeting straight(Meeting meeting)
    {
        meeting.velocities.across1 = meeting.velocities.across2 = 0.0;
        return meeting;
    }

    [[nodiscard]] PairHit part(const Meeting &meeting) const
    {
        const double overlap = 1.5 * std::abs(meeting.closing()) * m_h;
        const double distance = std::max(meeting.sum() - overlap, 0.5 * meeting.sum());
        return meet(meeting, distance, distance, m_h, 1);
    }

    /// The first hit of the pair in the student's own scene.
    [[nodiscard]] std::optional<PairHit> own() const
    {
        PairHit hit;
        hit.stage = {m_ground.own, false};
        Probe probe(m_program, hit.stage);
        if (!probe.runs() || probe.start().circles.size() < 2)
            return std::nullopt;
        const Preset &scene = probe.start();
        const std::vector<Flight> &flights = m_flight.at(scene.gravity, scene.timestep);
        const auto steps = static_cast<int>(secondsOfOwn / scene.timestep);
        for (int k = 1; k <= steps; ++k) {
            const std::vector<Circle> before = probe.world().circles;
            if (!probe.step())
                return std::nullopt;
            const double distance = length(before[1].position - before[0].position);
            if (distance > 1.5 * (before[0].radius + before[1].radius))
                continue;
            note(hit, before, probe, flights, k);
            if (!hit.answered)
                continue;
            hit.meeting = {.radius1 = before[0].radius,
                           .radius2 = before[1].radius,
                           .density1 = before[0].density,
                           .density2 = before[1].density,
                           .restitution = scene.restitution,
                           .velocities = hit.cameParts()};
            return hit;
        }
        return std::nullopt;
    }

    /// Circle 2, pushed, comes back from the wall behind it: how often they meet, and whether it
    /// runs through circle 1.
    void meetAgain(MeasuredPair &pair) const
    {
        Preset preset = m_ground.stage();
        preset.timestep = m_h;
        preset.circles[0].body.position = {2.57, 0.41};
        preset.circles[0].body.velocity = {2.3 * slowness(m_h), 0.0};
        preset.circles[1].body.position = {3.13, 0.41};
        Probe probe(m_program, {preset, true});
        const std::vector<Flight> &flights = m_flight.at({}, m_h);
        PairHit hit{.slowness = slowness(m_h)};
        bool was = false;
        for (int k = 1; k * m_h < 1.3; ++k) {
            const std::vector<Circle> before = probe.world().circles;
            if (!probe.step())
                break;
            hit.answered = false;
            const Vec2 d = before[1].position - before[0].position;
            if (length(d) < 0.5)
                note(hit, before, probe, flights, k);
            const bool is = hit.answered && length(hit.push1()) > 0.1;
            pair.ownContacts += is && !was ? 1 : 0;
            was = is;
            const bool nears = dot(d, before[0].velocity - before[1].velocity) > 0.0;
            pair.ranThrough |= pair.ownContacts == 1 && !is && nears && length(d) < 0.2;
        }
        if (pair.ranThrough)
            pair.returning = scan({.velocities = {.along2 = -1.2}});
    }

private:
    /// Who goes too far in a step of h is thrown so much more gently, and comes as far as others.
    [[nodiscard]] double slowness(double h) const { return 1.0 / m_flight.at({}, h)[0].way.x; }

    /// \param distance  of the centres at the start, m
    /// \param aim       when they are so far apart, they stand along the line that is asked for, m
    [[nodiscard]] Stage stageOf(const Meeting &m, double distance, double aim, double h) const
    {
        Preset preset = m_ground.stage();
        preset.timestep = h;
        preset.restitution = m.restitution;
        const double angle = m.degrees * std::numbers::pi / 180.0;
        const Vec2 n{std::cos(angle), std::sin(angle)};
        const Vec2 t = perpendicular(n);
        const Vec2 middle{0.17, -0.23};
        Circle &a = preset.circles[0].body;
        Circle &b = preset.circles[1].body;
        const PairVelocities &v = m.velocities;
        const double time = m.closing() > 0.0 ? (distance - aim) / m.closing() : 0.0;
        const auto place = [&](double along, double across) {
            return middle + along * distance * n - time * across * t;
        };
        const auto velocity = [&](double along, double across) {
            return slowness(h) * (along * n + across * t);
        };
        a = {place(-0.5, v.across1), velocity(v.along1, v.across1), m.radius1, m.density1};
        b = {place(0.5, v.across2), velocity(v.along2, v.across2), m.radius2, m.density2};
        for (std::size_t i = 2; i < preset.circles.size(); ++i)
            preset.circles[i].body.position = {-3.1, -3.1 + static_cast<double>(i - 2)};
        return {preset, true};
    }

    [[nodiscard]] PairHit meet(const Meeting &meeting, double distance, double aim, double h,
                               int most = 400) const
    {
        PairHit hit{.meeting = meeting, .slowness = slowness(h)};
        hit.stage = stageOf(meeting, distance, aim, h);
        Probe probe(m_program, hit.stage);
        const std::vector<Flight> &flights = m_flight.at({}, h);
        for (int k = 1; k <= most && probe.runs(); ++k) {
            const std::vector<Circle> before = probe.world().circles;
            const Vec2 d = before[1].position - before[0].position;
            // A wall is not their affair.
            if (isNearWall(before[0]) || isNearWall(before[1]))
                break;
            // They have run through each other.
            if (k > 2 && dot(d, before[0].velocity - before[1].velocity) < 0.0
                && length(d) > 0.3 * meeting.sum())
                break;
            if (!probe.step())
                break;
            note(hit, before, probe, flights, k);
            if (hit.answered)
                break;
        }
        return hit;
    }

    static bool isNearWall(const Circle &c)
    {
        return std::max(std::abs(c.position.x), std::abs(c.position.y)) > 3.7 - c.radius;
    }

    static void note(PairHit &hit, const std::vector<Circle> &before, const Probe &probe,
                     const std::vector<Flight> &flights, int k)
    {
        const double h = probe.start().timestep;
        const Motion free1 = flights[0].after(before[0], h);
        const Motion free2 = flights[1].after(before[1], h);
        const auto turned = [&](Vec2 made, Vec2 free) {
            return length(made - free) > kick * (hit.slowness + length(free));
        };
        const Circle &now1 = probe.circle(0);
        const Circle &now2 = probe.circle(1);
        if (!turned(now1.velocity, free1.velocity) && !turned(now2.velocity, free2.velocity))
            return;
        hit.answered = true;
        hit.step = k;
        const Vec2 d = before[1].position - before[0].position;
        const Vec2 next = free2.position - free1.position;
        hit.before = length(d);
        hit.reached = dot(next, d) < 0.0 ? 0.0 : length(next);
        hit.normal = normalized(d);
        hit.nextNormal = normalized(next);
        hit.parting = dot(next, free1.velocity - free2.velocity) < 0.0;
        hit.came1 = free1.velocity / hit.slowness;
        hit.came2 = free2.velocity / hit.slowness;
        hit.left1 = now1.velocity / hit.slowness;
        hit.left2 = now2.velocity / hit.slowness;
        noteLeap(hit, 0, before[0].position, free1.position, now1.position);
        noteLeap(hit, 1, before[1].position, free2.position, now2.position);
        const Vec2 then = now2.position - now1.position;
        hit.partsInside = length(then) < (now1.radius + now2.radius) * (1.0 - 1e-9)
                          && dot(then, now2.velocity - now1.velocity) > 0.0;
    }

    /// Whether a circle was put farther from its path than any way of parting two puts it.
    static void noteLeap(PairHit &hit, int circle, Vec2 before, Vec2 free, Vec2 now)
    {
        const double leap = std::min(length(now - before), length(now - free));
        if (leap > 0.6 * hit.meeting.sum() + 4.0 * length(free - before)) {
            hit.leaper = circle;
            hit.landed = now;
        }
    }

    const QString *m_program;
    const Ground &m_ground;
    const MeasuredFlight &m_flight;
    double m_h;
    /// Where circles of these radii were answered at that angle, if not where their rims meet, m.
    mutable std::map<std::array<double, 3>, double> m_seen{};
};

PairVelocities partsOf(Vec2 v1, Vec2 v2, Vec2 n)
{
    const Vec2 t = perpendicular(n);
    return {dot(v1, n), dot(v1, t), dot(v2, n), dot(v2, t)};
}

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

bool partsAlike(const PairVelocities &a, const PairVelocities &b)
{
    return isAlike(a.along1, b.along1, hitBlur) && isAlike(a.across1, b.across1, hitBlur)
           && isAlike(a.along2, b.along2, hitBlur) && isAlike(a.across2, b.across2, hitBlur);
}

bool answersAlike(const std::vector<PairHit> &a, const std::vector<PairHit> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const PairHit &p, const PairHit &q) {
                          return p.answered == q.answered && p.leaper == q.leaper
                                 && (!p.answered || partsAlike(p.leftParts(), q.leftParts()));
                      });
}

} // namespace

PairVelocities PairHit::cameParts() const
{
    return partsOf(came1, came2, normal);
}

PairVelocities PairHit::leftParts() const
{
    return partsOf(left1, left2, normal);
}

bool PairHit::isAligned() const
{
    const double angle = meeting.degrees * std::numbers::pi / 180.0;
    return length(normal - Vec2{std::cos(angle), std::sin(angle)}) < 0.002;
}

bool PairHit::fits(double distance) const
{
    return reached - 1e-9 <= distance && distance <= before + (before - reached) + 1e-9;
}

namespace {

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

} // namespace

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
    const auto within = [](const Ground::Range &r, double share) {
        return r.low + share * (r.high - r.low);
    };
    const double small = within(asked.radii, 0.25);
    const double large = within(asked.radii, 0.75);
    const double light = within(asked.densities, 0.25);
    const double dense = within(asked.densities, 0.75);
    const double e = *std::max_element(asked.restitutions.begin(), asked.restitutions.end());
    PairVelocities slow =
        asked.bothMove ? PairVelocities{0.7, 0.1, -0.5, 0.1} : PairVelocities{1.2, 0.0, 0.0, 0.0};
    if (asked.oblique)
        slow.across1 = 0.25;
    for (const double degrees : {3.0, 47.0, 88.0, 131.0, 222.0, 318.0})
        contacts.push_back(range.scan({degrees, small, large, light, light, e, slow}));
    if (asked.radii.isVaried()) {
        for (const double degrees : {33.0, 205.0})
            contacts.push_back(range.scan({degrees, large, small, light, light, e, slow}));
        contacts.push_back(range.scan({111.0, large, large, light, light, e, slow}));
    }
    const std::vector<PairVelocities> all = throws(asked);
    for (const double degrees : {33.0, 118.0}) {
        for (const PairVelocities &v : all)
            equals.push_back(range.look({degrees, small, small, light, light, e, v}));
    }
    noteLate(equals);
    modes = {equals.begin(), equals.begin() + static_cast<std::ptrdiff_t>(all.size())};
    const PairVelocities &both = all.size() > 4 ? all[4] : all.back();
    if (asked.radii.isVaried()) {
        radii.push_back(range.look({33.0, small, large, light, light, e, both}));
        radii.push_back(range.look({33.0, large, small, light, light, e, both}));
        radii.push_back(range.look({61.0, large, large, light, light, e, both}));
    }
    if (asked.densities.isVaried()) {
        densities.push_back(range.look({33.0, small, small, light, dense, e, both}));
        densities.push_back(range.look({33.0, small, small, dense, light, e, both}));
    }
    for (const double other : asked.restitutions) {
        if (other != e)
            rebounds.push_back(range.look({33.0, small, small, light, light, other, both}));
    }
    for (const double degrees : {21.0, 143.0}) {
        PairVelocities apart{-0.9, 0.4, 0.8, 0.4};
        partings.push_back(range.part({degrees, small, small, light, light, e, apart}));
    }
    if (range.isUsual())
        own = range.own();
    range.meetAgain(*this);
}

bool MeasuredPair::contactIsLike(const MeasuredPair &other) const
{
    if (isJudged != other.isJudged || contacts.size() != other.contacts.size()
        || modes.size() != other.modes.size())
        return false;
    const auto meetAlike = [](const PairHit &a, const PairHit &b) {
        return a.answered == b.answered
               && (!a.answered
                   || (a.parting == b.parting
                       && std::abs(a.reached - b.reached)
                              <= std::abs(a.before - a.reached) + std::abs(b.before - b.reached)));
    };
    const auto answered = [](const PairHit &a, const PairHit &b) {
        return a.answered == b.answered;
    };
    return std::equal(contacts.begin(), contacts.end(), other.contacts.begin(), meetAlike)
           && std::equal(modes.begin(), modes.end(), other.modes.begin(), answered);
}

bool MeasuredPair::sequelIsLike(const MeasuredPair &other) const
{
    const auto answered = [](const PairHit &a, const PairHit &b) {
        return a.answered == b.answered;
    };
    const auto leaps = [](const PairHit &a, const PairHit &b) { return a.leaper == b.leaper; };
    return (ownContacts > 1) == (other.ownContacts > 1)
           && std::equal(contacts.begin(), contacts.end(), other.contacts.begin(),
                         other.contacts.end(), leaps)
           && std::equal(partings.begin(), partings.end(), other.partings.begin(),
                         other.partings.end(), answered);
}

bool MeasuredPair::responseIsLike(const MeasuredPair &other) const
{
    if (isJudged != other.isJudged || own.has_value() != other.own.has_value())
        return false;
    if (own && !partsAlike(own->leftParts(), other.own->leftParts())
        && length(own->left1 - other.own->left1) + length(own->left2 - other.own->left2) > 0.1)
        return false;
    return answersAlike(equals, other.equals) && answersAlike(radii, other.radii)
           && answersAlike(densities, other.densities) && answersAlike(rebounds, other.rebounds);
}

} // namespace cradle
