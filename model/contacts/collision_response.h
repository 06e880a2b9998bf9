// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

namespace cradle {

/// What \p law makes of the velocities of two circles that meet along \p n (unit, from a to b):
///     stop             v_a' = v_b' = 0
///     swap velocities  v_a' = v_b, v_b' = v_a
///     swap normal      the parts along n change hands, the parts across it stay
///     impulse          v_a' = v_a − J/m_a, v_b' = v_b + J/m_b with the impulse of a frictionless
///                      contact, J = (1 + e) μ (v_a − v_b)·n n and μ = m_a m_b / (m_a + m_b)
/// Only approaching circles respond, so that touching ones do not stick. Source: conserved momentum
/// and Newton's restitution law; derived in docs/physics.md, 3.
/// \param restitution  e, from 0 (no rebound) to 1 (elastic)
/// \return whether anything changed
bool respond(CircleLaw law, Circle &a, Circle &b, Vec2 n, double restitution);

/// Reflects the part of \p velocity along \p n (unit, into the wall): v_n' = −e v_n. The wall
/// does not move; the part along the wall stays. A circle that leaves the wall is left alone.
/// \return whether anything changed
bool reflect(Vec2 &velocity, Vec2 n, double restitution);

} // namespace cradle
