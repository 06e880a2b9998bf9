// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"

#include <algorithm>
#include <cmath>

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

Vec2 centreOfMass(std::span<const Circle> circles)
{
    Vec2 sum;
    double all = 0.0;
    for (const Circle &circle : circles) {
        sum += mass(circle) * circle.position;
        all += mass(circle);
    }
    return circles.empty() ? Vec2{} : sum / all;
}

double greatestDistance(std::span<const Circle> circles, std::span<const Circle> other)
{
    double greatest = 0.0;
    for (std::size_t i = 0; i < std::min(circles.size(), other.size()); ++i)
        greatest = std::max(greatest, length(circles[i].position - other[i].position));
    return greatest;
}

Deviation deviation(std::span<const Circle> run, std::span<const Circle> exact, Vec2 gravity,
                    double halfWidth)
{
    Q_ASSERT(run.size() == exact.size());
    if (run.empty())
        return {};
    double squares = 0.0;
    for (std::size_t i = 0; i < run.size(); ++i)
        squares += lengthSquared(run[i].position - exact[i].position);
    return {.greatest = greatestDistance(run, exact),
            .rootMeanSquare = std::sqrt(squares / static_cast<double>(run.size())),
            .energy = measure(run, gravity, halfWidth).total()
                      - measure(exact, gravity, halfWidth).total()};
}

} // namespace cradle
