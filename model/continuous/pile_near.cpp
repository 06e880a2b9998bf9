// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_near.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

NearPair wallPair(const Pile &pile, Pile::Body body, Pile::Body wall)
{
    const Circle &c = pile.circles[body];
    NearPair near{.a = body, .b = wall, .normal = pile.outwards(wall)};
    near.gap = pile.rules.halfWidth - c.radius - dot(c.position, near.normal);
    const double closing = dot(c.velocity + pile.dt * pile.rules.gravity, near.normal);
    near.met = near.gap <= pile.apart ? 0.0 : closing > 0.0 ? near.gap / closing : -1.0;
    near.met = near.met <= pile.dt ? near.met : -1.0;
    near.speed = dot(c.velocity, near.normal)
                 + std::max(near.met, 0.0) * dot(pile.rules.gravity, near.normal);
    return near;
}

NearPair circlePair(const Pile &pile, Pile::Body first, Pile::Body second)
{
    const Circle &a = pile.circles[first];
    const Circle &b = pile.circles[second];
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const double distance = quickLength(d);
    const double sum = a.radius + b.radius;
    NearPair near{.a = first, .b = second, .normal = d / distance, .gap = distance - sum};
    near.met = near.gap <= pile.apart ? 0.0 : -1.0;
    const double approach = -dot(d, v);
    const double rest = distance * distance - sum * sum;
    const double discriminant = approach * approach - lengthSquared(v) * rest;
    if (near.met < 0.0 && approach > 0.0 && discriminant > 0.0) {
        const double time = rest / (approach + std::sqrt(discriminant));
        if (time <= pile.dt) {
            near.met = time;
            near.normal = normalized(d + time * v);
            near.gap = dot(d, near.normal) - sum;
        }
    }
    near.speed = -dot(v, near.normal);
    return near;
}

} // namespace

std::vector<double> foreseenWays(const Pile &pile)
{
    double fastest = 0.0;
    for (const Circle &c : pile.circles)
        fastest = std::max(fastest, lengthSquared(c.velocity));
    std::vector<double> ways;
    ways.reserve(pile.circles.size());
    // A slow one may be kicked by a fast one.
    for (const Circle &c : pile.circles)
        ways.push_back(
            pile.dt
            * (std::max(quickLength(c.velocity), 0.5 * std::sqrt(fastest)) + 2.0 * pile.gain));
    return ways;
}

void findNearPairs(const Pile &pile, std::span<const double> ways, std::vector<NearPair> &pairs)
{
    using Body = Pile::Body;
    pairs.clear();
    double widest = 0.0;
    for (const Circle &c : pile.circles)
        widest = std::max(widest, c.radius);
    const double farthest = *std::max_element(ways.begin(), ways.end());
    for (Body i = 0; i < pile.count(); ++i) {
        const Circle &c = pile.circles[i];
        const double reach = c.radius + ways[i];
        const auto look = [&](Body begin, Body end) {
            for (Body j = begin; j < end; ++j) {
                const double near = reach + pile.circles[j].radius + ways[j];
                if (lengthSquared(pile.circles[j].position - c.position) <= near * near)
                    pairs.push_back(circlePair(pile, i, j));
            }
        };
        pile.grid.visitRunsAfter(i, pile.upright(c.position), reach + widest + farthest, look);
        if (pile.rules.laws.walls != WallLaw::Reflect)
            continue;
        for (const Wall wall : allWalls) {
            if (dot(c.position, outwardNormal(wall)) + reach >= pile.rules.halfWidth)
                pairs.push_back(wallPair(pile, i, pile.count() + static_cast<Body>(wall)));
        }
    }
}

} // namespace cradle
