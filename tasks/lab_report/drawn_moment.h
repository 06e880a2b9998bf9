// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"

#include <QByteArray>

#include <vector>

namespace cradle {

/// A scene at one moment of a run, and how its circles came there: all that a drawing of it needs,
/// so that it can be drawn where nothing may run. A plain value, of numbers with five digits.
struct DrawnMoment {
    struct Body {
        QString colour{}; ///< \#rrggbb
        double radius = 0.2;
        Vec2 position{};
        Vec2 velocity{};
        std::vector<Vec2> way{}; ///< places before, the oldest first; empty in crowds

        friend bool operator==(const Body &, const Body &) = default;
    };

    double halfWidth = 4.0; ///< of the square, m
    double time = 0.0;      ///< s
    std::vector<Body> bodies{};

    friend bool operator==(const DrawnMoment &, const DrawnMoment &) = default;
};

/// No more circles are drawn, and no more points of all their ways.
inline constexpr std::size_t mostBodiesOfMoment = 400;
inline constexpr std::size_t mostWayPoints = 2'000;

/// The scene of \p run at its state \p index, which it has.
[[nodiscard]] DrawnMoment drawnMoment(const Observation &run, qint64 index);

/// The moment as a drawing of 300 × 300 px, with the ways up to it and the velocities.
[[nodiscard]] QByteArray sceneSvg(const DrawnMoment &moment);

} // namespace cradle
