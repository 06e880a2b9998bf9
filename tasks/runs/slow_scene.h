// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/random.h"
#include "tasks/runs/scene_spec.h"

namespace cradle {

/// Speeds of what comes slowest to a wall, m/s.
inline constexpr Vec2 creepingSpeeds{0.15, 0.3};

/// What the slow hits of a check share.
struct SlowHits {
    double speed = 4.0;       ///< in what gravity makes in a step
    double firstMoment = 0.0; ///< within a step, from 0 to 1
};
[[nodiscard]] SlowHits drawSlowHits(Random &random);

/// Sends the circles of \p spec slowly, in turn with \p i, onto the wall that gravity pulls to and
/// onto the one opposite. The scenes divide a step evenly by when in it the wall is met: a circle
/// that is still beyond the wall after a step of its way back shows in some of them, whatever the
/// seed.
void placeSlowHit(Preset &preset, const SceneSpec &spec, int i, const SlowHits &hits,
                  Random &random);

/// Sends the circles of \p spec slowly to a wall beside, however fast they fall.
/// \param side  −1 or 1: which of the two
void placeCreepingHit(Preset &preset, const SceneSpec &spec, double side, Random &random);

/// How often circles are let go low.
inline constexpr int letGoScenes = 3;

/// Lets the circles of \p spec go at rest, so low that they come to the wall that gravity pulls to
/// with a few times what it makes in a step, in shorter and shorter steps with \p k: a program that
/// takes a slow circle for one that rests lets it sink.
/// \return s from the start until the hit is over
[[nodiscard]] double placeLetGo(Preset &preset, const SceneSpec &spec, int k, Random &random);

} // namespace cradle
