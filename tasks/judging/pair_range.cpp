// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_range.h"

#include "tasks/runs/meeting_scene.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double kick = 1e-8; ///< of a velocity, relative: what no rounding makes
constexpr double secondsOfOwn = 6.0;

} // namespace

PairRange::PairRange(const QString *program, const Ground &ground, const MeasuredFlight &flight)
    : m_program(program)
    , m_ground(ground)
    , m_paths(program, ground, flight)
    , m_h(ground.stage().timestep)
{
}

PairHit PairRange::scan(const Meeting &meeting) const
{
    return meet(meeting, 2.2137 * meeting.sum(), meeting.sum(), m_h);
}

PairHit PairRange::look(const Meeting &meeting) const
{
    const double way = std::abs(meeting.closing()) * shortStep;
    const std::array key{meeting.radius1, meeting.radius2, meeting.degrees};
    const auto seen = m_seen.find(key);
    const double guess = seen == m_seen.end() ? meeting.sum() : seen->second;
    PairHit hit = meet(meeting, guess + 2.4 * way, guess, shortStep, fewSteps);
    if (hit.answered && !hit.isAtOnce)
        return hit;
    // It is not where it should be: where it is, scan() knows to a step.
    PairHit coarse = scan(meeting);
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
    const PairHit exact = meet(meeting, m_seen[key] + 2.4 * way, m_seen[key], shortStep, fewSteps);
    return exact.answered ? exact : fine;
}

Meeting PairRange::straight(Meeting meeting)
{
    meeting.velocities.across1 = meeting.velocities.across2 = 0.0;
    return meeting;
}

PairHit PairRange::approach(const Meeting &meeting) const
{
    const double way = meeting.closing() * m_h;
    return meet(meeting, meeting.sum() + 2.4 * way, meeting.sum(), m_h, 2 * fewSteps);
}

PairHit PairRange::part(const Meeting &meeting) const
{
    const double overlap = 1.5 * std::abs(meeting.closing()) * m_h;
    const double distance = std::max(meeting.sum() - overlap, 0.5 * meeting.sum());
    PairHit hit = meet(meeting, distance, distance, m_h, 1);
    if (!m_paths.areEven())
        return hit;
    hit.afterRest = isAnsweredAfterRest(hit);
    hit.again = hit.answered && isAnsweredAgain(hit);
    hit.anew = hit.answered && isAnsweredAnew(hit);
    return hit;
}

bool PairRange::isTurned(const std::vector<Circle> &before, const Probe &probe) const
{
    const auto differs = [&](int i) {
        const Vec2 free = m_paths.free(static_cast<std::size_t>(i), before, m_h).velocity;
        return length(probe.circle(i).velocity - free) > 1e-6;
    };
    return differs(0) || differs(1);
}

/// Whether what was answered in the first step is answered again before they are apart.
bool PairRange::isAnsweredAgain(const PairHit &hit) const
{
    constexpr int steps = 8;
    Probe probe(m_program, hit.stage);
    for (int k = 1; k <= steps; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (length(before[1].position - before[0].position) > hit.meeting.sum() || !probe.step())
            return false;
        if (k > 1 && isTurned(before, probe))
            return true;
    }
    return false;
}

std::optional<PairHit> PairRange::own() const
{
    PairHit hit;
    hit.stage = {m_ground.own, false};
    Probe probe(m_program, hit.stage);
    if (!probe.runs() || probe.start().circles.size() < 2)
        return std::nullopt;
    const Preset &scene = probe.start();
    const auto steps = static_cast<int>(secondsOfOwn / scene.timestep);
    for (int k = 1; k <= steps; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            return std::nullopt;
        const double distance = length(before[1].position - before[0].position);
        // What a wall turns is no answer.
        if (distance > 1.5 * (before[0].radius + before[1].radius) || isNearWall(before[0])
            || isNearWall(before[1]))
            continue;
        note(hit, before, probe, k, scene.gravity);
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

Stage PairRange::stageOf(const Meeting &m, double distance, double aim, double h) const
{
    Preset preset = m_ground.stage();
    preset.timestep = h;
    preset.restitution = m.restitution;
    const Vec2 n = fromAngle(m.degrees);
    const Vec2 t = perpendicular(n);
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    const PairVelocities &v = m.velocities;
    const double time = m.closing() > 0.0 ? (distance - aim) / m.closing() : 0.0;
    const auto place = [&](double along, double across) {
        return m.middle + along * distance * n - time * across * t;
    };
    const auto velocity = [&](double along, double across) {
        return m_paths.slowness(h) * (along * n + across * t);
    };
    a = {place(-0.5, v.across1), velocity(v.along1, v.across1), m.radius1, m.density1};
    b = {place(0.5, v.across2), velocity(v.along2, v.across2), m.radius2, m.density2};
    for (std::size_t i = 2; i < preset.circles.size(); ++i)
        preset.circles[i].body.position = {-3.1, -3.1 + static_cast<double>(i - 2)};
    return {preset, true};
}

PairHit PairRange::meet(const Meeting &meeting, double distance, double aim, double h,
                        int most) const
{
    PairHit hit{.meeting = meeting, .slowness = m_paths.slowness(h)};
    hit.stage = stageOf(meeting, distance, aim, h);
    Probe probe(m_program, hit.stage);
    std::vector<Circle> before = probe.world().circles;
    for (int k = 1; k <= most && probe.runs(); ++k) {
        const Vec2 d = before[1].position - before[0].position;
        // A wall is not their affair.
        if (isNearWall(before[0]) || isNearWall(before[1]))
            break;
        // They have run through each other.
        if (k > 2 && dot(d, before[0].velocity - before[1].velocity) < 0.0
            && length(d) > 0.3 * meeting.sum())
            break;
        const bool isHeld = hit.isHeld();
        const std::vector<Circle> set = m_paths.aimed(before, h);
        if (!m_paths.areEven()) {
            World world = probe.world();
            world.circles = set;
            probe.place(world);
        }
        if (!probe.step()) {
            hit.stopped = true;
            break;
        }
        note(hit, before, probe, k);
        // A run that begins as this step does shows the same.
        if (!m_paths.areEven() && (hit.answered || hit.isHeld() != isHeld)) {
            hit.step = 1;
            for (std::size_t i = 0; i < 2; ++i)
                hit.stage.preset.circles[i].body = set[i];
        }
        if (hit.answered)
            break;
        std::vector<Circle> next = probe.world().circles;
        for (std::size_t i = 0; i < 2 && !m_paths.areEven(); ++i)
            next[i].position = m_paths.free(i, before, h).position;
        before = std::move(next);
    }
    return hit;
}

bool PairRange::isNearWall(const Circle &c, double way)
{
    return std::max(std::abs(c.position.x), std::abs(c.position.y)) + way > 3.7 - c.radius;
}

void PairRange::note(PairHit &hit, const std::vector<Circle> &before, const Probe &probe, int k,
                     Vec2 gravity) const
{
    const double h = probe.start().timestep;
    const Motion free1 = m_paths.free(0, before, h, gravity);
    const Motion free2 = m_paths.free(1, before, h, gravity);
    const auto turned = [&](Vec2 made, Vec2 free) {
        return length(made - free) > kick * (hit.slowness + length(free));
    };
    const Circle &now1 = probe.circle(0);
    const Circle &now2 = probe.circle(1);
    if (!turned(now1.velocity, free1.velocity) && !turned(now2.velocity, free2.velocity)) {
        if (hit.isHeld())
            return;
        hit.moved1 = length(now1.position - free1.position) > 1e-7;
        hit.moved2 = length(now2.position - free2.position) > 1e-7;
        if (hit.isHeld()) {
            hit.step = k;
            noteLeap(hit, 0, before[0].position, free1.position, now1);
            noteLeap(hit, 1, before[1].position, free2.position, now2);
        }
        return;
    }
    hit.answered = true;
    hit.step = k;
    hit.isAtOnce = k == 1;
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
    noteLeap(hit, 0, before[0].position, free1.position, now1);
    noteLeap(hit, 1, before[1].position, free2.position, now2);
    notePlaces(hit, before, probe, gravity);
    const Vec2 then = now2.position - now1.position;
    hit.after = length(then);
    hit.partsInside = length(then) < (now1.radius + now2.radius) * (1.0 - 1e-9)
                      && dot(then, now2.velocity - now1.velocity) > 0.0;
}

void PairRange::noteLeap(PairHit &hit, int circle, Vec2 before, Vec2 free, const Circle &now) const
{
    const double leap = std::min(length(now.position - before), length(now.position - free));
    // Who is hit much too hard flies as far in the rest of the step.
    const double flown = length(now.velocity) * m_h;
    if (leap > std::max(0.6 * hit.meeting.sum() + 4.0 * length(free - before), 1.01 * flown)) {
        hit.leaper = circle;
        hit.landed = now.position;
    }
}

void PairRange::notePlaces(PairHit &hit, const std::vector<Circle> &before, const Probe &probe,
                           Vec2 gravity) const
{
    // Who is set before every step is not where its own step would take it.
    if (!m_paths.areEven() || !hit.isMet())
        return;
    constexpr double smallest = 1e-5; // m: less is a drift of every step
    const double h = probe.start().timestep;
    const Vec2 normal = normalized(hit.normal + hit.nextNormal);
    for (const int i : {0, 1}) {
        const Circle &was = before[static_cast<std::size_t>(i)];
        const Circle &now = probe.circle(i);
        const Motion free = m_paths.free(static_cast<std::size_t>(i), before, h, gravity);
        const HitPlace place{
            .apart = i == 0 ? -1.0 * normal : normal,
            .turn = length(hit.nextNormal - hit.normal),
            .overlap = std::max(0.0, hit.meeting.sum() - std::min(hit.before, hit.reached)),
            .isLate = hit.before < hit.meeting.sum(),
            .free = free.position - was.position,
            .bounced = h / m_paths.slowness(h) * now.velocity,
            .made = now.position - was.position};
        const auto found = misplacementOf(place, smallest + 2.0 * length(gravity) * h * h);
        if (found && (!hit.misplaced || found->by > hit.misplaced->by)) {
            hit.misplaced = found;
            hit.misplacedCircle = i;
        }
    }
}

} // namespace cradle
