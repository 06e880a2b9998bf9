// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/random.h"
#include "tasks/runs/scene_spec.h"

namespace cradle {

/// What the scenes of one check are drawn from, in the order of their numbers, from 0: the same
/// seed draws the same.
class SceneDraws
{
protected:
    /// \param submission  the student's laws
    /// \param seed        unless the check has one of its own
    SceneDraws(const Preset &submission, const CheckSpec &check, qint64 seed);

    /// The angle of scene \p place of all, which divide the angles evenly; degrees.
    [[nodiscard]] double spread(double place) const;
    /// Somewhere in the part of the angles that is scene \p i's; where that ends at an axis,
    /// exactly there: a program may forget one of the two parts, and level or upright the other is
    /// nothing.
    [[nodiscard]] double angleOf(int i);
    /// Between the least and the most.
    [[nodiscard]] double range(Vec2 lowHigh) { return m_random.between(lowHigh.x, lowHigh.y); }
    /// How many circles scenes of this check have at least.
    [[nodiscard]] std::size_t needed() const;
    /// The student's laws over an empty stage with \p circles circles.
    [[nodiscard]] Preset stage(int i, std::size_t circles);
    /// One towards each side wall, one towards the ceiling and, of many, one towards the floor, so
    /// that a few mm show there, and that slow circles are turned at all.
    [[nodiscard]] bool doesCreep(int i) const;
    /// Brings the radius of \p shot to one end of their range and those of the others to the other
    /// end, by more than a step of any shot is long: a wall that takes the wrong one is found out.
    void partRadii(Preset &preset, std::size_t shot, bool isLarge) const;
    /// Whether scene \p i is one of two hits: of several e each has some, in turn, the largest
    /// more.
    [[nodiscard]] bool meetsAgain(int i, double e) const;

    const Preset &m_submission;
    SceneSpec m_spec;
    Random m_random;
};

} // namespace cradle
