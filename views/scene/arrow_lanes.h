// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/circle.h"

#include <vector>

namespace cradle {

/// A way from one place to another, m.
struct Stretch {
    Vec2 from{};
    Vec2 to{};
};

/// Finds places for the arrows of a hit: each starts at the rim of its circle and keeps its
/// direction and length, but moves aside where it would cover the other disc or another arrow.
class ArrowLanes
{
public:
    /// \param discs  the circles that stay visible
    ArrowLanes(std::vector<Circle> discs, double pixelsPerMetre);

    /// Other arrows keep \p gap px away from \p stretch where they run alongside it.
    void occupy(const Stretch &stretch, double gap = 8.0);
    /// Where the arrow \p shaft (m) of \p circle, which is one of the discs, stands; occupies it.
    Stretch place(const Circle &circle, Vec2 shaft);

private:
    struct Lane {
        Stretch stretch;
        double gap; ///< px
    };

    [[nodiscard]] bool blocked(const Stretch &stretch, const Circle &own) const;
    [[nodiscard]] int crossings(const Stretch &stretch) const;

    std::vector<Circle> m_discs;
    std::vector<Lane> m_lanes;
    double m_scale; ///< px/m
};

} // namespace cradle
