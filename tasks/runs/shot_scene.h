// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/random.h"

namespace cradle {

/// When a circle that flies freely from \p position meets a wall of \p preset for the first time,
/// s; infinity if it never does.
[[nodiscard]] double timeToWall(const Preset &preset, const Circle &circle);

/// A place about the middle, anywhere: no program can know it.
[[nodiscard]] Vec2 drawStart(Random &random);

/// Carries circle \p shot, which has its place and velocity already, so far along its way that it
/// comes to a wall well within \p duration s.
void bringNear(Preset &preset, std::size_t shot, double duration);

/// Lets the other circles drift, or under gravity fly, where circle \p shot and the walls are far
/// for \p duration s: what happens to the shot must not stop them, and a check sees whether it
/// does. If it can be, they move away from the wall to which the shot comes first, so that a
/// program that asks there for the velocity of another circle is found out.
void drawOthers(Preset &preset, std::size_t shot, double duration, Random &random);

} // namespace cradle
