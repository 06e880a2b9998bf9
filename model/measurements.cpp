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
            .kinetic = 0.5 * m * lengthSquared(circle.velocity),
            .potential = -m * dot(gravity, circle.position - Vec2{0.0, -halfWidth})};
}

Totals measure(std::span<const Circle> circles, Vec2 gravity, double halfWidth)
{
    Totals sum;
    for (const Circle &circle : circles)
        sum += measure(circle, gravity, halfWidth);
    return sum;
}

double dissipated(const Hit &hit, std::span<const Circle> circles)
{
    const auto lost = [&](int index, Vec2 before, Vec2 after) {
        return 0.5 * mass(circles[static_cast<std::size_t>(index)])
               * (lengthSquared(before) - lengthSquared(after));
    };
    double sum = lost(hit.a, hit.beforeA, hit.afterA);
    if (hit.kind == Hit::Kind::Circle)
        sum += lost(hit.b, hit.beforeB, hit.afterB);
    return sum;
}

} // namespace cradle
