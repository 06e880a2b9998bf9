// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/ground.h"
#include "tasks/judging/measured_flight.h"

#include <vector>

namespace cradle {

/// The ways of two circles that nothing hits, by the measured flight of a program: what a throw at
/// each other must know to bring them together, and a hit is read against.
class PairPaths
{
public:
    static constexpr double shortStep = 1e-4; ///< s: the line of centres hardly turns in a step

    PairPaths(const QString *program, const Ground &ground, const MeasuredFlight &flight);

    /// Whether it is known how each of them goes on by the velocities of both.
    [[nodiscard]] bool areKnown() const;

    /// Whether both go as far by their own velocities, one as the other. Else they are set before
    /// every step so that they come to where their velocities would bring them.
    [[nodiscard]] bool areEven() const;

    /// Who goes too far in a step of \p h is thrown so much more gently, and comes as far as
    /// others.
    [[nodiscard]] double slowness(double h) const;

    /// Where circle \p i of \p circles is one step later, if nothing is hit.
    [[nodiscard]] Motion free(std::size_t i, const std::vector<Circle> &circles, double h,
                              Vec2 gravity = {}) const;

    /// Those who fly on from \p circles, set so that one step brings both to where they should be.
    [[nodiscard]] std::vector<Circle> aimed(const std::vector<Circle> &circles, double h) const;

private:
    /// Whether circles of other sizes, and with another e, fly like those, too.
    [[nodiscard]] bool fliesAlike() const;
    /// Whether circle \p i, one of those that are not even, goes on as its law says.
    [[nodiscard]] bool followsLaw(std::size_t i, double h) const;
    /// The way of circle \p i of \p circles in a step, m.
    [[nodiscard]] Vec2 wayOf(std::size_t i, const std::vector<Circle> &circles, double h) const;

    const QString *m_program;
    const Ground &m_ground;
    const MeasuredFlight &m_flight;
    double m_h;
};

} // namespace cradle
