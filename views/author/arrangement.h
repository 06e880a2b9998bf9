// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/result.h"

namespace cradle {

/// Equal circles at rest in a pattern: a grid and a ring about the middle of the square, a rack
/// with its tip there.
struct Arrangement {
    enum class Pattern {
        Rack, ///< a triangle whose tip points to the left: 1, 2, 3 … in a column
        Grid, ///< rows and columns
        Ring  ///< at equal angles
    };
    Pattern pattern = Pattern::Rack;
    int rows = 3;           ///< columns of a rack, rows of a grid, circles of a ring; from 1
    int columns = 3;        ///< of a grid, from 1
    double radius = 0.2;    ///< m
    double gap = 0.02;      ///< between the rims of neighbours, m; from 0
    bool hasStriker = true; ///< one more, circle 1, comes from the left at 3 m/s
};

/// "Rack", in the language of the moment.
[[nodiscard]] QString nameOf(Arrangement::Pattern pattern);

/// How many circles there are.
[[nodiscard]] int countOf(const Arrangement &arrangement);

/// The scene; walls reflect, and hits keep momentum and energy.
/// \return an Error that says why they find no place: too many, or too large for the square
[[nodiscard]] Result<Preset> presetOf(const Arrangement &arrangement);

} // namespace cradle
