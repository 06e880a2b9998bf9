// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

#include <optional>

namespace cradle {

/// Tools that the kinds of checks share: what happened in one step of an observation.
namespace motion {

/// A velocity that differs by less than this (m/s, times 1 + speed) is the same: a hundred times
/// what rounding makes of a few hundred operations on doubles, a thousandth of any mistake.
inline constexpr double sameVelocity = 1e-9;
/// The same for positions (m), which gather the rounding of many steps.
inline constexpr double samePosition = 1e-9;

[[nodiscard]] bool isSame(Vec2 a, Vec2 b, double tolerance = sameVelocity);

/// The "tolerance" of \p check, whose kind has one.
[[nodiscard]] double toleranceOf(const CheckSpec &check);
/// The "restitution" that the check names, else that of the scene.
[[nodiscard]] double restitutionOf(const CheckSpec &check, const Observation &o);

/// The gravity that the check names, m/s²; nullopt if it names none.
[[nodiscard]] std::optional<Vec2> askedGravity(const CheckSpec &check);
/// The same, else that of the scene.
[[nodiscard]] Vec2 gravityOf(const CheckSpec &check, const Observation &o);

/// What changed the velocity of circle \p i in the step after \p k besides gravity, m/s.
[[nodiscard]] Vec2 kick(const Observation &o, int i, qint64 k, Vec2 gravity);
[[nodiscard]] bool isKicked(const Observation &o, int i, qint64 k, Vec2 gravity,
                            double tolerance = sameVelocity);

/// What is wrong with the motion of circle \p i where it meets nothing: in most steps in the open
/// gravity is not all that changes it, or it goes another way than v Δt. Checks of hits must not
/// tell that as a hit's.
/// \param axis  along which it is changed, a unit vector; without one, all of it counts
[[nodiscard]] std::optional<Fault> steadyFault(const Observation &o, int i, Vec2 gravity,
                                               std::optional<Vec2> axis = {});

/// That gravity is not all that changes circle \p i in the step after \p k, where it meets nothing.
[[nodiscard]] Fault changedInOpen(const Observation &o, int i, qint64 k, Vec2 gravity);

/// The furthest that circle \p i can come in the step after \p k, m.
[[nodiscard]] double travel(const Observation &o, int i, qint64 k, Vec2 gravity);

/// The same in that step and the one before, m.
[[nodiscard]] double recentTravel(const Observation &o, int i, qint64 k, Vec2 gravity);

/// How far handling a hit may move a circle, in the ways of the step and the one before: back to
/// the old position, onto the wall or as far inside as it was outside.
inline constexpr double longestLeap = 3.0;

/// What is wrong if circle \p i goes on somewhere else after step \p k.
/// \param way  how far it may have come in two steps, m
[[nodiscard]] std::optional<Fault> leap(const Observation &o, int i, qint64 k, double way);

/// From the rim to \p wall, m; negative beyond it.
[[nodiscard]] double wallGap(const Observation &o, const Circle &c, Wall wall);

/// Whether circle \p i can reach a wall in the step after \p k.
[[nodiscard]] bool isNearWall(const Observation &o, int i, qint64 k, Vec2 gravity);

/// Whether circle \p i can reach another circle in the step after \p k.
[[nodiscard]] bool isNearCircle(const Observation &o, int i, qint64 k, Vec2 gravity);

/// Whether nothing can meet circle \p i in the step after \p k: no wall and, if the check says
/// that its circles collide ("collisions"), no other circle.
[[nodiscard]] bool isFree(const CheckSpec &check, const Observation &o, int i, qint64 k,
                          Vec2 gravity);

} // namespace motion
} // namespace cradle
