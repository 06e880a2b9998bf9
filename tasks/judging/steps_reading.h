// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/flight_reading.h"
#include "tasks/judging/flight_scenes.h"

namespace cradle {

/// Flights of one program with one timestep, in the four scenes that tell its law.
struct FlownSteps {
    flights::Steps rest{};
    flights::Steps first{};
    flights::Steps second{};
    flights::Steps shifted{};

    [[nodiscard]] bool areMade() const
    {
        return rest.made && first.made && second.made && shifted.made;
    }
};

/// Whether a step of \p timestep s goes about as far, \p way in m, as by the velocity that it
/// begins with, m/s, which is not 0: what gravity adds to the way is less.
[[nodiscard]] bool goesByVelocity(Vec2 way, Vec2 velocity, double timestep);

/// The law that a circle follows in them, all of which are made.
/// \param h  the timestep, s
[[nodiscard]] Flight lawOf(const FlownSteps &steps, double h, std::size_t circle);

} // namespace cradle
