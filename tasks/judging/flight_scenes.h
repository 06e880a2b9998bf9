// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/flight_reading.h"
#include "tasks/judging/ground.h"
#include "tasks/judging/probe.h"

#include <optional>
#include <vector>

/// The short flights in which the free motion of a program is measured.
namespace cradle::flights {

/// From one place to another, m.
inline constexpr Vec2 shift{0.31, -0.23};

/// The states before and after the second step of a flight.
struct Steps {
    bool made = false;
    std::vector<Circle> start{};
    std::vector<Circle> before{};
    std::vector<Circle> after{};
};

/// How the circles start: at rest, with two kinds of velocities that have nothing in common, in
/// another place, one alone with a velocity, the same with all others elsewhere, all with a high
/// one, all with a low one, all the other way, all falling fast; as in First, to the places of Fast
/// one step later, and as in Fast, to those of First.
enum class Scene {
    Rest,
    First,
    Second,
    Shifted,
    Alone,
    Apart,
    Fast,
    Slow,
    Back,
    Falling,
    Ahead,
    Behind
};
/// After so many steps a run is late.
inline constexpr qint64 lateSteps = 97;

/// \param mover  in Scene::Alone and Scene::Apart the only circle that moves
[[nodiscard]] Preset flightPreset(const Ground &ground, Vec2 gravity, double h, Scene scene,
                                  std::size_t mover = 0);

/// \param from  the step that the run is at when it begins
[[nodiscard]] Steps fly(const QString *program, const Preset &preset, qint64 from = 0);

/// The second step of circle \p i; nothing where it was not made.
[[nodiscard]] std::optional<Flight::Step> secondStep(const Steps &run, std::size_t i);

} // namespace cradle::flights
