// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/random.h"
#include "tests/scenes.h"

#include <vector>

namespace cradle::scenes {

/// A start that solvers of collisions stumble over, and how long to run it.
struct AwkwardScene {
    const char *name = "";
    Preset preset{};
    double seconds = 1.0;
    std::size_t mostHits = 0; ///< more would be hits without end
};

/// As many circles as a preset may have.
inline constexpr int crowdSize = limits::maxCircles;

/// Reflecting walls and the impulse law; \p timing is the caller's.
inline Preset boxed(std::initializer_list<PresetCircle> circles, double restitution = 1.0,
                    Vec2 gravity = {})
{
    Preset preset = scene(circles, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact});
    preset.restitution = restitution;
    preset.gravity = gravity;
    return preset;
}

/// Radius 0.25 m, so that places in quarters of a metre touch without rounding.
inline PresetCircle quarter(Vec2 position, Vec2 velocity = {})
{
    return circle(position, velocity, 0.25);
}

/// Five in touch from x = 0 on, and a sixth that comes at 2 m/s from the left.
inline Preset cradleOfFive()
{
    return boxed({quarter({-1.5, 0}, {2, 0}), quarter({0, 0}), quarter({0.5, 0}), quarter({1, 0}),
                  quarter({1.5, 0}), quarter({2, 0})});
}

/// Four that run into the four corners at one moment and meet again in the middle.
inline Preset fourCorners(double restitution)
{
    return boxed({quarter({2, 2}, {2, 2}), quarter({-2, 2}, {-2, 2}), quarter({-2, -2}, {-2, -2}),
                  quarter({2, -2}, {2, -2})},
                 restitution);
}

/// Two that run into one at rest between them, the left one first.
inline Preset threeInLine(double restitution)
{
    return boxed({quarter({-1, 0}, {1, 0}), quarter({0, 0}), quarter({1.75, 0}, {-2, 0})},
                 restitution);
}

/// 30 circles of mixed radii that fall in a heap.
inline Preset heap(double restitution)
{
    Preset preset = boxed({}, restitution, {0, -g});
    Random random(7);
    for (int i = 0; i < 30; ++i) {
        const Vec2 site{-3.0 + 1.2 * (i % 6), -3.0 + 1.4 * (i / 6)};
        preset.circles.push_back(circle(site + Vec2{random.between(-0.1, 0.1), 0.0},
                                        {random.between(-1.0, 1.0), 0.0},
                                        random.between(0.2, 0.45)));
    }
    return preset;
}

/// \p count circles, a fifth of the square, at 2 m/s.
inline Preset crowd(int count)
{
    Preset preset = boxed({});
    const double area = 0.2 * 4.0 * halfWidth * halfWidth;
    preset.fill = CircleFill{
        .count = count, .radius = std::sqrt(area / (pi * count)), .rmsSpeed = 2.0, .seed = 3};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    return preset;
}

/// All of them; timing is still to be set.
inline std::vector<AwkwardScene> awkwardScenes()
{
    const Vec2 down{0, -g};
    const double snug = 3.999; // m, in a square of 4 m: 2 mm to and fro
    // 1e9 as the ratio of masses of equal radii
    const PresetCircle light = circle({1, 0}, {}, 0.2, Integrator::Verlet, 1e-4);
    const PresetCircle heavy = circle({-1, 0}, {2, 0}, 0.2, Integrator::Verlet, 1e5);
    const PresetCircle fast = circle({-1, 0}, {1e6, 3e5});
    return {
        {"two in touch at rest", boxed({quarter({0, 0}), quarter({0.5, 0})}), 1.0, 0},
        {"two in touch, closing", boxed({quarter({0, 0}, {1, 0}), quarter({0.5, 0}, {-1, 0})}), 1.0,
         1},
        {"two in touch, falling", boxed({quarter({0, 0}), quarter({0.5, 0})}, 1.0, down), 5.0, 40},
        {"two in touch, upright, falling", boxed({quarter({0, 0}), quarter({0, 0.5})}, 0.5, down),
         5.0, 400},
        {"two in touch, upright, falling slowly",
         boxed({quarter({0, -3.5}), quarter({0, -3.0})}, 0.5, {0, -0.5}), 20.0, 400},
        {"three in a row, both ends closing",
         boxed({quarter({-0.5, 0}, {1, 0}), quarter({0, 0}), quarter({0.5, 0}, {-1, 0})}), 1.0, 10},
        {"three in a row, one runs in",
         boxed({quarter({-1, 0}, {2, 0}), quarter({0, 0}), quarter({0.5, 0})}), 1.0, 10},
        {"three in a triangle, closing",
         boxed({quarter({-0.25, 0}, {1, 0}), quarter({0.25, 0}, {-1, 0}),
                quarter({0, std::sqrt(0.1875)}, {0, -1})}),
         1.0, 20},
        {"cradle of five", cradleOfFive(), 1.5, 6},
        {"corners, elastic", fourCorners(1.0), 10.0, 200},
        {"corners, e = 0.5", fourCorners(0.5), 10.0, 400},
        {"a graze", boxed({quarter({-2, 0.5}, {2, 0}), quarter({0, 0})}), 1.5, 1},
        {"a graze, both moving and falling",
         boxed({quarter({-2, 1.5}, {2, 0}), quarter({2, 1}, {-2, 0})}, 1.0, down), 1.0, 4},
        {"nearly as wide as the square", boxed({circle({0, 0}, {3, 2}, snug)}, 1.0, down), 2.0,
         20'000},
        {"nearly as wide as the square, e = 0.9", boxed({circle({0, 0}, {3, 2}, snug)}, 0.9, down),
         2.0, 5'000},
        {"a light one hit by 1e9 times its mass", boxed({heavy, light}), 1.0, 10},
        {"1e9 times its mass hit by a light one",
         boxed({circle({-1, 0}, {}, 0.2, Integrator::Verlet, 1e5),
                circle({1, 0}, {-2, 1e-3}, 0.2, Integrator::Verlet, 1e-4)}),
         1.0, 10},
        {"radii of 1 : 1000",
         boxed({circle({0, 0}, {0.3, 0.1}, 2.0), circle({3, 0}, {-2, 1}, 0.002),
                circle({-3, 1}, {2, 1}, 0.002)},
               1.0, down),
         4.0, 20'000},
        {"a million metres a second", boxed({fast, circle({1, 0})}), 0.1, 60'000},
        {"nothing moves and nothing pulls", boxed({circle({0, 0}), circle({1, 1})}), 1.0, 0},
        {"at rest on the floor", boxed({circle({0, -3.8})}, 0.5, down), 5.0, 0},
        {"at rest on the floor, elastic", boxed({circle({0, -3.8})}, 1.0, down), 5.0, 0},
        {"sliding on the floor", boxed({circle({0, -3.8}, {1, 0})}, 0.5, down), 5.0, 3},
        {"resting on each other", boxed({quarter({0, -3.75}), quarter({0, -3.25})}, 0.5, down), 5.0,
         0},
        {"a heap, e = 0", heap(0.0), 10.0, 50'000},
        {"a heap, e = 0.5", heap(0.5), 10.0, 100'000},
        {"a heap, e = 0.9", heap(0.9), 10.0, 200'000},
        {"collapse of three, e = 0.05", threeInLine(0.05), 2.0, 5'000},
        {"collapse of three, e = 0", threeInLine(0.0), 2.0, 100},
        // One step: at 2 m/s that is five radii, some two free ways of a circle.
        {"a crowd", crowd(crowdSize), dt, 200'000},
    };
}

} // namespace cradle::scenes
