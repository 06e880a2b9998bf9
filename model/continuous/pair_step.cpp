// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pair_step.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Closing speeds below this share of the speeds may be rest; ContinuousStep sees to them.
constexpr double leastClosing = 1e-6;

/// Whether a circle may come to a wall in a step at \p speed (m/s).
bool reachesWall(const Crowd &crowd, const SortSkin &skin, double dt, Crowd::Slot slot,
                 double speed)
{
    const Vec2 place = crowd.motions[slot].position;
    return crowd.rules.laws.walls == WallLaw::Reflect
           && std::max(std::abs(place.x), std::abs(place.y)) + crowd.radii[slot]
                      + skin.travel(dt, speed + crowd.gravity * dt)
                  >= crowd.rules.halfWidth;
}

} // namespace

std::optional<PairStep> pairStep(const Crowd &crowd, const SortSkin &skin, const TimeStep &step,
                                 Crowd::Slot a, Crowd::Slot b)
{
    const CircleLaw law = crowd.rules.laws.circles;
    const double e = law == CircleLaw::Impulse ? crowd.rules.restitution : 1.0;
    if ((law != CircleLaw::Impulse && law != CircleLaw::SwapNormal) || e == 0.0)
        return std::nullopt;
    const auto s =
        timeToDistance(crowd.path(a), crowd.path(b), crowd.radii[a] + crowd.radii[b], step.dt);
    if (!s)
        return std::nullopt;
    const Vec2 g = crowd.rules.gravity;
    Motion ma = advance(crowd.integrator(a), crowd.motions[a], g, *s);
    Motion mb = advance(crowd.integrator(b), crowd.motions[b], g, *s);
    const Vec2 n = normalized(mb.position - ma.position);
    const double closing = dot(ma.velocity - mb.velocity, n);
    const bool swaps = law == CircleLaw::SwapNormal;
    const double massA = mass(crowd.circle(a));
    const double massB = mass(crowd.circle(b));
    const double wa = swaps ? 1.0 : 1.0 / massA;
    const double wb = swaps ? 1.0 : 1.0 / massB;
    const double impulse = (1.0 + e) * closing / ((wa + wb) * dot(n, n));
    const Vec2 changeA = -(impulse * wa) * n;
    const Vec2 changeB = (impulse * wb) * n;
    const double fastest = std::sqrt(std::max(
        {lengthSquared(crowd.motions[a].velocity), lengthSquared(crowd.motions[b].velocity),
         lengthSquared(ma.velocity + changeA), lengthSquared(mb.velocity + changeB)}));
    const double gain = crowd.gravity * step.dt;
    if (closing <= leastClosing * (fastest + gain) || reachesWall(crowd, skin, step.dt, a, fastest)
        || reachesWall(crowd, skin, step.dt, b, fastest))
        return std::nullopt;

    Hit hit{.time = step.end - step.dt + *s,
            .step = step.number,
            .a = static_cast<int>(crowd.ids[a]),
            .b = static_cast<int>(crowd.ids[b]),
            .normal = n,
            .impulse = impulse * wa * massA,
            .beforeA = ma.velocity,
            .beforeB = mb.velocity,
            .loss = -0.5 * massA * dot(2.0 * ma.velocity + changeA, changeA)
                    - 0.5 * massB * dot(2.0 * mb.velocity + changeB, changeB)};
    ma.velocity += changeA;
    mb.velocity += changeB;
    hit.afterA = ma.velocity;
    hit.afterB = mb.velocity;
    return PairStep{hit, advance(Integrator::Verlet, ma, g, step.dt - *s),
                    advance(Integrator::Verlet, mb, g, step.dt - *s), fastest + gain};
}

} // namespace cradle
