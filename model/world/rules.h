// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

namespace cradle {

/// What a step needs to know of a preset: everything but the circles' state.
struct Rules {
    double halfWidth = 4.0;   ///< of the square, m
    Vec2 gravity{};           ///< m/s²
    double restitution = 1.0; ///< e, 0 to 1
    Laws laws{};
    std::vector<Integrator> integrators{}; ///< one per circle
};

/// The rules of \p preset; \c exact timing moves every circle on its parabola.
[[nodiscard]] Rules rulesOf(const Preset &preset);

} // namespace cradle
