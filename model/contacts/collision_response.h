// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <optional>

namespace cradle {

/// Impulse (N s) that a frictionless contact gives to \p b; \p a receives its negative.
///     J = (1 + e) μ max(0, (v_a − v_b)·n) n,   μ = m_a m_b / (m_a + m_b)
/// n points from a to b. Source: conserved momentum and Newton's restitution law; derived in
/// docs/physics.md, 3.
/// \param restitution  e, from 0 (no rebound) to 1 (elastic)
/// \return zero if the bodies separate; nullopt if their centres coincide
[[nodiscard]] std::optional<Vec2> contactImpulse(const Circle &a, const Circle &b,
                                                 double restitution);

/// What \p law makes of the velocities of two circles that meet along \p n (unit, from a to b):
///     stop             v_a' = v_b' = 0
///     swap velocities  v_a' = v_b, v_b' = v_a
///     swap normal      the parts along n change hands, the parts across it stay
///     impulse          v' = v ± J/m with the impulse above
/// Only approaching circles respond, so that touching ones do not stick.
/// \return whether anything changed
bool respond(CircleLaw law, Circle &a, Circle &b, Vec2 n, double restitution);

/// Reflects the part of \p velocity along \p n (unit, into the wall): v_n' = −e v_n. The wall
/// does not move; the part along the wall stays. A circle that leaves the wall is left alone.
/// \return whether anything changed
bool reflect(Vec2 &velocity, Vec2 n, double restitution);

} // namespace cradle
