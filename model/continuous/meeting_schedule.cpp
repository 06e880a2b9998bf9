// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/meeting_schedule.h"

#include "model/world/world.h"

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

/// Shares of a step by which rounding may bring a meeting forward.
constexpr double timeRounding = 1e-6;

/// Calls visit(b) for those of a run that come within \p slack (m) of touching in the time left if
/// they fly straight on; most do not, so this goes without branches: the distance at s is at least
/// √(d² − 2 s approach).
template <class Visit>
void sieve(const Crowd &crowd, const BroadPhase &near, Crowd::Slot a, Crowd::Slot begin,
           Crowd::Slot end, double slack, Visit visit)
{
    using Slot = Crowd::Slot;
    constexpr Slot most = 32;
    Slot passed[most];
    const Motion first = crowd.motions[a];
    const double radius = crowd.radii[a] + slack;
    const double span = 2.0 * near.timeLeft();
    while (begin < end) {
        const Slot stop = std::min(end, begin + most);
        Slot count = 0;
        for (Slot b = begin; b < stop; ++b) {
            const Vec2 d = crowd.motions[b].position - first.position;
            const double sum = radius + crowd.radii[b];
            passed[count] = b;
            count += lengthSquared(d) - sum * sum
                             < span * dot(d, first.velocity - crowd.motions[b].velocity)
                         ? 1U
                         : 0U;
        }
        for (Slot k = 0; k < count; ++k)
            visit(passed[k]);
        begin = stop;
    }
}

/// What gravity and different integrators can add to a straight way from now on, m.
double slackOf(const Crowd &crowd, const BroadPhase &near, bool disturbed)
{
    const double span = near.timeLeft();
    double bends = crowd.alike ? 0.0 : crowd.gravity * near.dt() * (span + near.dt());
    if (crowd.sleep.count() > 0) // they do not fall with the others
        bends += crowd.gravity * span * (0.5 * span + near.dt());
    // What rests may fall, or may be fallen upon, in the next step.
    return bends + (disturbed ? 2.0 * crowd.gravity * near.dt() * near.dt() : 0.0);
}

} // namespace

void MeetingSchedule::fill(const Crowd &crowd, const BroadPhase &near)
{
    for (auto &due : m_due)
        due.clear();
    const SortSkin &skin = near.skin();
    const double bends = slackOf(crowd, near, false);
    for (Slot a = 0; a < crowd.count(); ++a) {
        addWalls(crowd, near, a);
        if (crowd.rules.laws.circles == CircleLaw::None)
            continue;
        const auto look = [&](Slot begin, Slot end) {
            sieve(crowd, near, a, begin, end, bends, [&](Slot b) {
                addPair(crowd, near, {a, b}, false);
            });
        };
        if (a < crowd.small) {
            const double travel = skin.travel(near.timeLeft(), crowd.speed(a));
            near.grid().visitRunsAfter(a, crowd.motions[a].position,
                                       crowd.radii[a] + crowd.smallRadius + skin.width()
                                           + std::min(skin.width(), travel),
                                       look);
        }
        look(std::max(a + 1, crowd.small), crowd.count());
    }
}

void MeetingSchedule::addAround(const Crowd &crowd, const BroadPhase &near, Slot slot)
{
    addWalls(crowd, near, slot);
    if (crowd.rules.laws.circles == CircleLaw::None)
        return;
    const double slack = slackOf(crowd, near, true);
    const auto look = [&](Slot begin, Slot end) {
        sieve(crowd, near, slot, begin, end, slack, [&](Slot b) {
            if (b != slot)
                addPair(crowd, near, {slot, b}, true);
        });
    };
    const SortSkin &skin = near.skin();
    const double travel = skin.travel(near.timeLeft(), crowd.speed(slot));
    near.grid().visitRuns(crowd.motions[slot].position,
                          crowd.radii[slot] + crowd.smallRadius + skin.width()
                              + std::min(2.0 * skin.width(), travel),
                          look);
    look(crowd.small, crowd.count());
}

void MeetingSchedule::addAgain(const Crowd &crowd, const BroadPhase &near, const Crowd::Pair &pair)
{
    if (pair.b == Crowd::wall)
        addWalls(crowd, near, pair.a);
    else
        addPair(crowd, near, pair, false);
}

/// \param disturbed  one of them may rest or hang on others, and not fall as it flies
void MeetingSchedule::addPair(const Crowd &crowd, const BroadPhase &near, const Crowd::Pair &pair,
                              bool disturbed)
{
    const auto [a, b] = pair;
    if (crowd.sleeps(a) || crowd.sleeps(b)) {
        addSleeper(crowd, near, pair);
        return;
    }
    const double dt = near.dt();
    const Vec2 d = crowd.motions[b].position - crowd.motions[a].position;
    Vec2 v = crowd.motions[b].velocity - crowd.motions[a].velocity;
    double reach = crowd.radii[a] + crowd.radii[b];
    if (disturbed && crowd.gravity > 0.0) {
        const double close = reach + dt * (std::sqrt(lengthSquared(v)) + 2.0 * crowd.gravity * dt);
        if (lengthSquared(d) <= close * close) {
            putDown(0.0, near, pair);
            return;
        }
    }
    if (!crowd.alike) {
        // From step to step the centres move in a straight line; inside a step the paths of
        // different integrators bend apart by no more than g Δt²/4.
        const double bend = pathCurvature(crowd.integrator(b)) - pathCurvature(crowd.integrator(a));
        v += (bend * dt) * crowd.rules.gravity;
        reach += 0.5 * crowd.gravity * dt * dt;
    }
    const double approach = -dot(d, v);
    const double gap = lengthSquared(d) - reach * reach;
    // Their distance at s is at least √(d² − 2 s approach).
    if (gap >= 2.0 * near.timeLeft() * approach)
        return;
    if (gap <= 0.0) {
        putDown(0.0, near, pair);
        return;
    }
    const double discriminant = approach * approach - lengthSquared(v) * gap;
    if (discriminant >= 0.0)
        putDown(gap / (approach + std::sqrt(discriminant)), near, pair);
}

/// Puts two down of which one sleeps: the other comes no faster than its speed and gravity allow.
void MeetingSchedule::addSleeper(const Crowd &crowd, const BroadPhase &near,
                                 const Crowd::Pair &pair)
{
    const auto [a, b] = pair;
    if (crowd.sleeps(a) && crowd.sleeps(b))
        return;
    const Motion &first = crowd.motions[a];
    const Motion &second = crowd.motions[b];
    const double gap = length(second.position - first.position) - crowd.radii[a] - crowd.radii[b];
    if (gap <= 0.0) {
        putDown(0.0, near, pair);
        return;
    }
    const double speed = length(second.velocity - first.velocity) + crowd.gravity * near.dt();
    putDown(2.0 * gap / (speed + std::sqrt(speed * speed + 2.0 * crowd.gravity * gap)), near, pair);
}

void MeetingSchedule::addWalls(const Crowd &crowd, const BroadPhase &near, Slot slot)
{
    if (crowd.rules.laws.walls != WallLaw::Reflect || crowd.sleeps(slot))
        return;
    const Motion &motion = crowd.motions[slot];
    const double room = crowd.rules.halfWidth - crowd.radii[slot];
    const double safe = room - 2.0 * near.skin().width();
    if (std::abs(motion.position.x) < safe && std::abs(motion.position.y) < safe)
        return;
    const double dt = near.dt();
    const double bend = 0.5 * crowd.gravity * dt * dt;
    const Vec2 g = crowd.rules.gravity;
    // From step to step every integrator is on a parabola.
    const Vec2 v = motion.velocity + (dt * (pathCurvature(crowd.integrator(slot)) - 0.5)) * g;
    constexpr double never = std::numeric_limits<double>::infinity();
    double first = never;
    for (const Wall side : allWalls) {
        const Vec2 n = outwardNormal(side);
        const auto s = timeToLine(room - bend - dot(motion.position, n), dot(v, n), 0.5 * dot(g, n),
                                  near.timeLeft());
        first = std::min(first, s.value_or(never));
    }
    if (first < never)
        putDown(first, near, {slot, Crowd::wall});
}

/// Notes that two may meet \p time s from now, and not before.
void MeetingSchedule::putDown(double time, const BroadPhase &near, const Crowd::Pair &pair)
{
    const double steps = std::max(0.0, time / near.dt() - timeRounding);
    if (steps < static_cast<double>(near.stepsLeft()))
        m_due[near.index() + static_cast<std::size_t>(steps)].push_back(pair);
}

} // namespace cradle
