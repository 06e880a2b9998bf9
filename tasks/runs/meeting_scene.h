// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/random.h"
#include "tasks/runs/scene_spec.h"

#include <numbers>

namespace cradle {

/// Where less of the speed is left, a circle that was hit comes to the wall together with the
/// other.
inline constexpr double leastRestitution = 0.2;

/// The unit vector \p degrees from the x axis; along an axis exactly so.
[[nodiscard]] inline Vec2 fromAngle(double degrees)
{
    const double a = degrees * std::numbers::pi / 180.0;
    const auto exact = [](double part) { return std::abs(part) < 1e-15 ? 0.0 : part; };
    return {exact(std::cos(a)), exact(std::sin(a))};
}

/// Throws circles 1 and 2 of \p preset so that they meet after half a second, with the line of
/// centres at \p degrees. Where \p spec has both move, the scenes \p i take turns in who catches up
/// with whom and who rests.
void placeEncounter(Preset &preset, const SceneSpec &spec, int i, double degrees, Random &random);

/// Circles 1 and 2, now equal, meet in front of a wall that sends circle 2 back within some of the
/// shortest timesteps, to a second hit with another line of centres: a program that pauses after a
/// hit misses it, and one that remembers a hit answers it by what it remembers.
/// \pre the restitution is leastRestitution or more
/// \return s from the start until the second hit is over
[[nodiscard]] double placeAgain(Preset &preset, const SceneSpec &spec, Random &random);

/// The heavier of circles 1 and 2 drives the other, which rests, straight at a wall and meets it
/// again when it comes back, some tenths of a second later and well away from the wall: a program
/// that pauses after a hit misses the second, and one that changes its law after the first is seen.
/// \pre the restitution is leastRestitution or more
/// \return s from the start until the second hit is over
[[nodiscard]] double placeRally(Preset &preset, const SceneSpec &spec, Random &random);

/// As after a hit that was told late: circles 1 and 2 overlap, and for one update more while they
/// part along a line at \p degrees.
void placeParting(Preset &preset, const SceneSpec &spec, double degrees, Random &random);

} // namespace cradle
