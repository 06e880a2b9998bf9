// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_range.h"

#include <cmath>
#include <numbers>

namespace cradle {

void PairRange::meetAgain(MeasuredPair &pair) const
{
    if (!m_paths.areEven())
        return;
    comeBack(pair, 3.13, 0.2);
    // From so near a wall that it is back within a few steps.
    const int contacts = pair.ownContacts;
    if (contacts > 1 && !pair.ranThrough) {
        comeBack(pair, 3.74, 0.345);
        pair.ranThroughAtOnce = pair.ranThrough;
        pair.ownContacts = pair.ranThrough ? 1 : contacts;
    }
    if (pair.ranThrough)
        pair.returning = scan({.velocities = {.along2 = -1.2}});
}

void PairRange::comeBack(MeasuredPair &pair, double place, double tooNear) const
{
    pair.ownContacts = 0;
    Preset preset = m_ground.stage();
    preset.circles[0].body.position = {place - 0.56, 0.41};
    preset.circles[0].body.velocity = {2.3 * m_paths.slowness(m_h), 0.0};
    preset.circles[1].body.position = {place, 0.41};
    Probe probe(m_program, {preset, true});
    PairHit hit{.slowness = m_paths.slowness(m_h)};
    bool was = false;
    std::vector<Circle> apart = probe.world().circles; // the last state in which they were
    for (int k = 1; k * m_h < 1.3; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            break;
        hit.answered = false;
        const Vec2 d = before[1].position - before[0].position;
        if (length(d) < 0.5)
            note(hit, before, probe, k);
        const bool is = hit.answered && length(hit.push1()) > 0.1;
        pair.ownContacts += is && !was ? 1 : 0;
        was = is;
        const bool nears = dot(d, before[0].velocity - before[1].velocity) > 0.0;
        if (pair.ownContacts == 1 && !is && nears && length(d) < tooNear && !pair.ranThrough) {
            pair.ranThrough = true;
            pair.ranThroughAnew = anew(apart, preset.restitution);
        }
        if (nears && length(d) > before[0].radius + before[1].radius)
            apart = before;
    }
}

PairHit PairRange::anew(const std::vector<Circle> &circles, double restitution) const
{
    PairHit hit{.slowness = m_paths.slowness(m_h)};
    hit.stage = {m_ground.stage(), true};
    hit.stage.preset.restitution = restitution;
    for (std::size_t i = 0; i < 2; ++i)
        hit.stage.preset.circles[i].body = circles[i];
    const Vec2 d = circles[1].position - circles[0].position;
    hit.meeting = {.degrees = std::atan2(d.y, d.x) * 180.0 / std::numbers::pi,
                   .radius1 = circles[0].radius,
                   .radius2 = circles[1].radius,
                   .density1 = circles[0].density,
                   .density2 = circles[1].density,
                   .restitution = restitution,
                   .middle = 0.5 * (circles[0].position + circles[1].position)};
    hit.came1 = circles[0].velocity;
    hit.came2 = circles[1].velocity;
    Probe probe(m_program, hit.stage);
    for (int k = 1; k <= fewSteps && !hit.answered; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            break;
        note(hit, before, probe, k);
    }
    return hit;
}

/// Whether it is answered once more when the circles are set as they were after one step: who
/// remembers a hit does not know that they have been apart.
bool PairRange::isAnsweredAnew(const PairHit &hit) const
{
    Probe probe(m_program, hit.stage);
    const World start = probe.world();
    if (!probe.step())
        return false;
    World set = probe.world();
    for (std::size_t i = 0; i < 2; ++i) {
        set.circles[i].position = start.circles[i].position;
        set.circles[i].velocity = start.circles[i].velocity;
    }
    probe.place(set);
    return probe.step() && isTurned(start.circles, probe);
}

/// Whether those that part are answered, too, when they rested where they are for a step: in the
/// first of a run a program may know of no step before with which it compares.
bool PairRange::isAnsweredAfterRest(const PairHit &hit) const
{
    Probe probe(m_program, hit.stage);
    const World start = probe.world();
    World rest = start;
    for (Circle &each : rest.circles)
        each.velocity = {};
    probe.place(rest);
    // Where nobody moves some programs stop: then the first step is all that is known.
    if (!probe.step())
        return hit.answered;
    World set = probe.world();
    for (std::size_t i = 0; i < 2; ++i) {
        set.circles[i].position = start.circles[i].position;
        set.circles[i].velocity = start.circles[i].velocity;
    }
    probe.place(set);
    return probe.step() ? isTurned(start.circles, probe) : hit.answered;
}

std::optional<PairHit> PairRange::twice(const Meeting &meeting) const
{
    constexpr int stepsAfterwards = 6;
    if (!m_paths.areEven())
        return std::nullopt;
    const double way = meeting.closing() * m_h;
    PairHit hit{.meeting = meeting, .slowness = m_paths.slowness(m_h)};
    hit.stage = stageOf(meeting, meeting.sum() + 2.4 * way, meeting.sum(), m_h);
    Probe probe(m_program, hit.stage);
    int first = 0;
    for (int k = 1; k <= (first == 0 ? 2 * fewSteps : first + stepsAfterwards); ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            break;
        hit.answered = hit.moved1 = hit.moved2 = false;
        note(hit, before, probe, k);
        if (first == 0 && hit.isMet())
            first = k;
        else if (first > 0 && hit.answered && hit.parting) {
            const PairHit again = anew(before, meeting.restitution);
            hit.anew = again.answered && again.step == 1;
            return hit;
        }
    }
    return std::nullopt;
}

std::optional<LaterHit> PairRange::later(double radius, double density, double e) const
{
    // Between them when circle 2 comes to the wall, at the speed that they met with.
    constexpr double stepsBetween = 4.5;
    constexpr double speed = 2.1; // m/s
    const double toWall = stepsBetween * m_h / e;
    // Where the wall, too, gives e times the speed back.
    const double nearing = 0.5 * (e * (1.0 + e) + 1.0 - e);
    const double touching = 2.0 * radius;
    const double sunk = touching * (1.0 - std::sqrt(0.75));
    const double back = (stepsBetween * m_h + sunk / speed) / nearing;
    // What circle 1 has across the first line brings it to one side until the second.
    const Vec2 v{speed, 0.5 * touching / (toWall + back)};
    Preset preset = m_ground.stage();
    preset.restitution = e;
    Circle &a = preset.circles[0].body;
    Circle &b = preset.circles[1].body;
    b = {{preset.halfWidth - radius - 0.5 * (1.0 + e) * speed * toWall, 0.41}, {}, radius, density};
    a = {b.position - Vec2{touching, 0.0} - 3.3 * m_h * v, v, radius, density};
    PairHit hit{.meeting = {.radius1 = radius,
                            .radius2 = radius,
                            .density1 = density,
                            .density2 = density,
                            .restitution = e},
                .stage = {preset, true}};
    Probe probe(m_program, hit.stage);
    std::optional<PairHit> first;
    bool was = false;
    for (int k = 1; k * m_h < toWall + 1.6 * back + 12.0 * m_h; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            break;
        hit.answered = hit.moved1 = hit.moved2 = false;
        note(hit, before, probe, k);
        const bool is = hit.answered && length(hit.push1()) > 0.1 && length(hit.push2()) > 0.1;
        if (is && !was && first)
            return LaterHit{*first, hit, anew(before, e)};
        if (is && !first)
            first = hit;
        was = is;
    }
    return std::nullopt;
}

} // namespace cradle
