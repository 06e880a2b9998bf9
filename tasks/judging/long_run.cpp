// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/long_run.h"

#include <algorithm>

namespace cradle {

namespace {

/// Steps after which circles that wait are set back: gravity has not taken them far.
constexpr int stepsAtOnce = 6;
/// What circles do in such a step at most, m.
constexpr double farInAStep = 0.3;
/// By how much their velocity changes in it at most, m/s, and how often what gravity gives.
constexpr double muchInAStep = 1.0;
constexpr double fallsInAStep = 3.0;

/// The longest timestep of the checks.
double longestStep(const Ground &ground)
{
    const auto &all = ground.timesteps;
    return all.empty() ? ground.own.timestep : *std::max_element(all.begin(), all.end());
}

} // namespace

LongRun::LongRun(const QString *program, const Ground &ground, const Preset &scene)
    : m_idle(ground.stage())
    , m_step(longestStep(ground))
    , m_probe(program, {scene, true})
{
    // None rests: what waits for rest would not be what it was.
    double side = 1.0;
    for (PresetCircle &circle : m_idle.circles) {
        circle.body.velocity = {0.31 * side, 0.47 * side};
        side = -side;
    }
}

void LongRun::set(const Preset &scene)
{
    m_wasSet = true;
    place(scene);
}

void LongRun::place(const Preset &scene)
{
    World world = m_probe.world();
    for (std::size_t i = 0; i < world.circles.size() && i < scene.circles.size(); ++i) {
        world.circles[i].position = scene.circles[i].body.position;
        world.circles[i].velocity = scene.circles[i].body.velocity;
    }
    m_probe.place(world);
}

void LongRun::wait(double seconds)
{
    const double end = time() + seconds;
    for (int k = 0; time() < end && runs(); ++k) {
        if (k % stepsAtOnce == 0)
            place(m_idle);
        const std::vector<Circle> before = m_probe.world().circles;
        if (!m_probe.step(m_step) || k > 0)
            continue;
        // Who keeps places or velocities to himself does not see that they were set; where nothing
        // was hit before, no answer to that comes late.
        const double most = muchInAStep + fallsInAStep * length(m_probe.start().gravity) * m_step;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Circle &now = m_probe.circle(static_cast<int>(i));
            m_isFollowed = m_isFollowed && length(now.position - before[i].position) < farInAStep
                           && (m_wasSet || length(now.velocity - before[i].velocity) < most);
        }
    }
}

} // namespace cradle
