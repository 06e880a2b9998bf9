// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"
#include "tasks/lab/lab.h"

namespace cradle {

/// The values of a check's "scene"; without one, their defaults.
struct SceneSpec {
    static constexpr double ownDuration = 10.0; ///< of the student's own scene, s

    SceneSpec() = default;
    /// \param ownTimestep  of the student's scene, s
    SceneSpec(const CheckSpec &check, double ownTimestep);

    QString kind = QStringLiteral("own");
    std::vector<int> circles{};
    int count = 1;
    double duration = 2.0;
    std::vector<double> timesteps{1.0 / 60.0};
    std::vector<double> restitutions{1.0};
    Vec2 gravity{};
    Vec2 speeds{1.0, 3.0};   ///< least and most
    Vec2 sideways{};         ///< of drops, m/s
    Vec2 angles{0.0, 360.0}; ///< from the x axis, degrees
    Vec2 radii{0.2, 0.2};
    Vec2 densities{7.8, 7.8};
    double offset = 0.0;
    bool bothMove = false;
    bool again = false; ///< some meet a second time at once

    [[nodiscard]] bool isOwn() const { return kind == QLatin1String("own"); }
};

/// Whether \p check looks at the student's own scene.
[[nodiscard]] bool showsOwnScene(const CheckSpec &check);

} // namespace cradle
