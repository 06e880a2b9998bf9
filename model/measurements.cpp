// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/measurements.h"

namespace cradle {

Totals &Totals::operator+=(const Totals &other)
{
    momentum += other.momentum;
    kinetic += other.kinetic;
    potential += other.potential;
    return *this;
}

Totals measure(const Circle &circle, Vec2 gravity, double halfWidth)
{
    const double m = mass(circle);
    return {.momentum = m * circle.velocity,
            .kinetic = kineticEnergy(circle),
            .potential = -m * dot(gravity, circle.position - Vec2{0.0, -halfWidth})};
}

Totals measure(std::span<const Circle> circles, Vec2 gravity, double halfWidth)
{
    Totals sum;
    for (const Circle &circle : circles)
        sum += measure(circle, gravity, halfWidth);
    return sum;
}

} // namespace cradle
