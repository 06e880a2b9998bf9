// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/contact_solver.h"

namespace cradle {

/// solveContacts() for so many that their matrix is better not written down: conjugate gradients
/// among the contacts that push, projected where one would pull, and a step down the gradient
/// where one that does not push should. Each round takes O(n), and rounds grow as the longest
/// chain. The closing speeds are met to 1e-9 of the largest wish, in units of a contact's own, or
/// as well as 4000 rounds can.
/// Source: Dostál: Optimal Quadratic Programming Algorithms, 2009, 5.8 (MPRGP).
/// \param inverseMasses  1/m of every body, 1/kg
void solveManyContacts(std::span<Contact> contacts, std::span<const double> inverseMasses);

} // namespace cradle
