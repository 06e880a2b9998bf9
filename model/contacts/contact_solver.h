// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <span>
#include <vector>

namespace cradle {

/// A contact of body \c a with body \c b, or with a wall that does not move (b < 0).
struct Contact {
    int a = 0;
    int b = -1;
    Vec2 normal{};        ///< unit vector from a to b
    double change = 0.0;  ///< wanted: by how much the closing speed must fall, m/s, ≥ 0
    double impulse = 0.0; ///< found: along the normal, on b, N s, ≥ 0
    bool rests = false;   ///< they stay in touch afterwards
    double loss = 0.0;    ///< kinetic energy that it took, J
};

/// Impulses of contacts that happen at the same moment, found together so that neither the order
/// of the contacts nor of the bodies matters:
///     J ≥ 0,   A J − change ≥ 0,   J·(A J − change) = 0,
///     A_ij = the fall of closing speed at i for a unit impulse at j
/// With change = (1 + e)·closing this is Newton's law of restitution for all of them at once;
/// for e = 1 it keeps the kinetic energy, for every e the momentum. The same equation with
/// accelerations gives the forces between bodies that rest on each other.
/// Solved by projected Jacobi iteration, so that symmetric data give symmetric results, and where
/// that is slow (long chains) finished by a dual active set; more than 64 by solveManyContacts().
/// What follows from it, and which contacts are of one moment: docs/physics.md, 5.
/// Source: Glocker, Pfeiffer: Multiple Impacts with Friction in Rigid Multibody Systems, 1995.
/// \param inverseMasses  1/m of every body, 1/kg
void solveContacts(std::span<Contact> contacts, std::span<const double> inverseMasses);

} // namespace cradle
