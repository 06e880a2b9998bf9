// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "tests/scenes.h"

/// Scenes that a simulation runs.
namespace cradle::scenes {

/// Two circles that meet each other and the walls, under gravity.
inline Preset lively()
{
    Preset preset = scene({circle({-2, 2.3}, {2, 0}, 0.2, Integrator::SymplecticEuler),
                           circle({2, 2}, {-1, 1}, 0.3, Integrator::Verlet)},
                          {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
    preset.gravity = {0, -g};
    preset.restitution = 0.9;
    return preset;
}

/// A circle that meets a wall after 1 s and then every 2 s.
inline Preset metronome()
{
    return scene({circle({0, 0}, {3.8, 0})}, {WallLaw::Reflect, CircleLaw::None, Timing::Discrete});
}

inline std::vector<World> worldsOf(const Preset &preset, int steps)
{
    Run run(preset);
    std::vector<World> worlds{run.world};
    for (int i = 0; i < steps; ++i) {
        run.steps(1);
        worlds.push_back(run.world);
    }
    return worlds;
}

inline void stepForward(Simulation &simulation, int steps)
{
    for (int i = 0; i < steps; ++i)
        simulation.stepForward();
}

} // namespace cradle::scenes
