// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/circle.h"
#include "model/world/integrator.h"
#include "model/world/result.h"

#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// What a wall does to a circle that runs into it.
enum class WallLaw { None, Reflect };

/// What two circles do to each other when they meet.
enum class CircleLaw {
    None,           ///< they pass through each other
    Stop,           ///< both velocities become zero
    SwapVelocities, ///< the whole velocities change hands
    SwapNormal,     ///< the parts along the line of centres change hands
    Impulse         ///< conserved momentum with masses and restitution
};

/// How the moment of a hit is found; docs/physics.md, 6, says what each way promises.
enum class Timing {
    Discrete,   ///< move; on a hit go back to the old position and respond
    Continuous, ///< the time of impact inside the step; the rest of the step is spent after it
    Exact       ///< no timestep: from event to event
};

/// The laws of a scene.
struct Laws {
    WallLaw walls = WallLaw::None;
    CircleLaw circles = CircleLaw::None;
    Timing timing = Timing::Discrete;

    friend bool operator==(const Laws &, const Laws &) = default;
};

/// A circle of a preset: the body and what the scene knows of it.
struct PresetCircle {
    QString name;
    Circle body{};
    QString colour = QStringLiteral("#1e90ff"); ///< \#rrggbb
    Integrator integrator = Integrator::Euler;

    friend bool operator==(const PresetCircle &, const PresetCircle &) = default;
};

/// A crowd of equal circles at random places, instead of a list.
struct CircleFill {
    int count = 0;         ///< 1 to maxCircles
    double radius = 0.05;  ///< m
    double rmsSpeed = 0.0; ///< √⟨v²⟩, m/s
    double density = 7.8;  ///< 1000 kg/m³
    qint64 seed = 1;       ///< the same seed, the same crowd

    friend bool operator==(const CircleFill &, const CircleFill &) = default;
};

/// A scene and its laws; SI units. A plain value: a run starts from it and never changes it.
struct Preset {
    QString name;
    double halfWidth = 4.0;       ///< of the square centred on the origin, m
    Vec2 gravity{};               ///< m/s²
    double restitution = 1.0;     ///< e, 0 to 1
    double timestep = 1.0 / 60.0; ///< s
    Laws laws{};
    std::vector<PresetCircle> circles{};
    std::optional<CircleFill> fill{}; ///< if set, circles were made from it

    friend bool operator==(const Preset &, const Preset &) = default;
};

/// Ranges of the numbers of a preset; a file or an edit outside them is refused.
namespace limits {
inline constexpr double maxTimestep = 0.1;       ///< s; coarser steps jump over circles
inline constexpr double minTimestep = 1e-6;      ///< s; a minute would be 60 million steps
inline constexpr double maxLength = 1e4;         ///< m; half width, position, radius
inline constexpr double minLength = 1e-6;        ///< m; half width, radius
inline constexpr double maxSpeed = 1e7;          ///< m/s, each component
inline constexpr double maxAcceleration = 1e4;   ///< m/s², each component
inline constexpr double maxDensity = 1e9;        ///< 1000 kg/m³
inline constexpr double minDensity = 1e-9;       ///< 1000 kg/m³
inline constexpr int maxCircles = 100'000;       ///< listed or filled
inline constexpr int maxName = 200;              ///< characters
inline constexpr double overlapTolerance = 1e-9; ///< of r₁ + r₂: touching circles are welcome
} // namespace limits

/// The first thing in \p preset that cannot be run, with the JSON pointer of its place:
/// a number that is not finite or out of its range; a circle outside the square where walls
/// reflect; circles that overlap where they act on each other.
[[nodiscard]] std::optional<Error> findFault(const Preset &preset);

/// The circles that \p fill stands for, in a square of \p halfWidth, not touching each other.
/// Velocities are Gaussian, their sum is zero, their root mean square is rmsSpeed.
/// \return an error if they do not fit
[[nodiscard]] Result<std::vector<PresetCircle>> makeCircles(const CircleFill &fill,
                                                            double halfWidth);

} // namespace cradle
