// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"
#include "tasks/checks/hit_places.h"

namespace cradle::kinds {

/// A circle that comes to the wall slower than gravity makes it in so many steps is about to rest:
/// then a program may well keep it there.
inline constexpr double restingSteps = 3.0;
/// A circle that comes to a wall slower than this has been stopped by it, m/s.
inline constexpr double stopped = 1e-6;

/// One look at a circle that changed its velocity by more than gravity.
struct Turn {
    const Observation &o;
    int circle;
    qint64 step;
    Vec2 gravity;
    double restitution;
    double tolerance;

    /// Judges what happened on one axis, between the walls \p low and \p high.
    [[nodiscard]] std::optional<Fault> faultAlong(Wall low, Wall high) const;
    /// Whether a wall turned or stopped it, and not only held what rests there.
    [[nodiscard]] bool isHit() const;
    /// Judges where a wall that turned or stopped it put it: at the wall, as far inside as it was
    /// beyond it, back, or on its way; not further in, and not along the wall.
    [[nodiscard]] std::optional<Fault> misplaced() const;

private:
    /// Whether the way of one step, along its normal, takes the rim to that wall, or the step did.
    [[nodiscard]] bool reaches(Wall wall) const;
    /// Whether the velocity along \p axis, \p kept but for the turn, m/s, has come out as a wall
    /// makes it: turned round, or e times as fast.
    [[nodiscard]] bool isMirrored(Vec2 axis, double kept, double after) const;
    /// Whether another circle, too, is changed in that step: then they may have answered each
    /// other.
    [[nodiscard]] bool isOfAnother() const;
    /// Judges a bounce off \p wall: v_n' = −e v_n, with gravity's part of the step before or after
    /// it.
    [[nodiscard]] std::optional<Fault> faultAt(Wall wall) const;
    /// What a wall makes of its place in that step, as if the wall were a circle that stays.
    [[nodiscard]] HitPlace placeAt(Wall wall) const;
    [[nodiscard]] Fault misplacedAt(Wall wall, const Misplacement &found) const;
    [[nodiscard]] Fault againAt(Wall wall) const;
    [[nodiscard]] Fault wrongAt(Wall wall, double first, double last) const;
    [[nodiscard]] Fault alongWall(Vec2 axis, double change) const;
    [[nodiscard]] Fault fault(const QString &text, double expected, double observed) const;
};

/// Where circle \p i, in a step in which it meets nothing, turns round as off the wall ahead of it,
/// no further from it than a circle is wide: that it does so before it touches.
[[nodiscard]] std::optional<Fault> turnBeforeWall(const Observation &o, int i, qint64 k,
                                                  Vec2 gravity);

} // namespace cradle::kinds
