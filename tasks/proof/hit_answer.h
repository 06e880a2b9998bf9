// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/runs/observation.h"

#include <optional>
#include <vector>

namespace cradle {

/// How the first hit of a run was answered: what a wrong restitution, or masses that grow with
/// another power of the radius, would have made of it.
struct HitAnswer {
    qint64 after = 0; ///< the first state behind the hit
    int a = 0;
    int b = -1;               ///< none at a wall
    Vec2 normal{};            ///< from b, or from the wall, to a
    double approach = 0.0;    ///< m/s along the normal, before the hit
    double restitution = 0.0; ///< parting over approach
    double massRatio = 0.0;   ///< m_b/m_a; 0 at a wall
    double radiusRatio = 1.0; ///< r_b/r_a

    /// What the velocities after the hit get, m/s, where e is larger by \p restitutionBy and mass
    /// grows with r^(3 + \p exponentBy).
    [[nodiscard]] std::vector<Vec2> shifts(std::size_t circles, double restitutionBy,
                                           double exponentBy) const;
};

/// The first hit that \p check is about: of its two circles, else of its first with a wall.
/// \param wallHit  the first state behind that; 0 if there is none
[[nodiscard]] std::optional<HitAnswer> answerIn(const CheckSpec &check, const Observation &run,
                                                qint64 wallHit);

} // namespace cradle
