// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/collision_detection.h"
#include "model/contacts/disc_grid.h"
#include "model/continuous/pile_contacts.h"
#include "model/world/rules.h"
#include "model/world/world.h"

namespace cradle {

/// A pile at the start of a step: its circles in the order of height, the four walls behind them,
/// and how exactly the step is to find their motion. No phase of the step changes it.
struct Pile {
    using Body = std::uint32_t; ///< a circle, or a wall

    /// \param names  of the circles, by which their pushes are known in the next step
    /// \param step  s
    Pile(const Rules &ruled, std::span<const Circle> unsorted, std::span<const std::uint32_t> names,
         double step);

    [[nodiscard]] Body count() const { return static_cast<Body>(circles.size()); }
    [[nodiscard]] bool isWall(Body body) const { return body >= count(); }
    [[nodiscard]] Vec2 outwards(Body wall) const
    {
        return outwardNormal(static_cast<Wall>(wall - count()));
    }
    /// A place in the frame of the grid, whose rows lie across gravity, m.
    [[nodiscard]] Vec2 upright(Vec2 place) const { return {cross(place, up), dot(place, up)}; }
    /// How far two bodies are apart if the circles are at \p places, m; negative where they
    /// overlap.
    [[nodiscard]] double gapBetween(Body a, Body b, std::span<const Vec2> places) const;
    /// Sets the velocities as they are without any push, v + g h.
    void setFree(PileBodies &bodies) const;

    const Rules &rules;
    double dt;              ///< h, s
    double gain;            ///< that gravity gives in the step, g h, m/s
    double apart = 0.0;     ///< what may be left between two that touch, m
    double borne = 0.0;     ///< an overlap that is as good as none, m
    double tolerance = 0.0; ///< and such an error of a closing speed, m/s
    Vec2 up{};              ///< unit vector against gravity
    DiscGrid grid;
    std::vector<std::uint32_t> order;  ///< where each circle is in the world
    std::vector<std::uint32_t> ids;    ///< of each circle
    std::vector<Circle> circles;       ///< at the start
    std::vector<double> inverseMasses; ///< of each body, 1/kg
};

} // namespace cradle
