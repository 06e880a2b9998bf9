// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"
#include "tasks/lab/lab.h"

namespace cradle {

/// The values of a check's "scene" with their defaults.
struct SceneSpec {
    /// \param ownTimestep  of the student's scene, s
    SceneSpec(const CheckSpec &check, double ownTimestep);

    QString kind;
    std::vector<int> circles;
    int count = 1;
    double duration = 2.0;
    std::vector<double> timesteps{};
    std::vector<double> restitutions{};
    Vec2 gravity{};
    Vec2 speeds{};   ///< least and most
    Vec2 sideways{}; ///< of drops, m/s
    Vec2 angles{};   ///< from the x axis, degrees
    Vec2 radii{};
    Vec2 densities{};
    double offset = 0.0;
    bool bothMove = false;
    bool again = false; ///< some meet a second time at once
};

} // namespace cradle
