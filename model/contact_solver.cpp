// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contact_solver.h"

#include <algorithm>

namespace cradle {

namespace {

/// A share of the largest impulse below which another round changes nothing worth having.
constexpr double converged = 1e-16;
/// Rounds for the hardest systems (long chains of touching bodies); most need under 60.
constexpr int maxRounds = 2000;

/// The fall of closing speed at \p i for a unit impulse at \p j.
double coupling(const Contact &i, const Contact &j, std::span<const double> inverseMasses)
{
    const auto weight = [&](int body) {
        return body < 0 ? 0.0 : inverseMasses[static_cast<std::size_t>(body)];
    };
    double sum = 0.0;
    if (i.a == j.a)
        sum += weight(i.a);
    if (i.b == j.b)
        sum += weight(i.b);
    if (i.a == j.b)
        sum -= weight(i.a);
    if (i.b == j.a)
        sum -= weight(i.b);
    return sum * dot(i.normal, j.normal);
}

} // namespace

void solveContacts(std::span<Contact> contacts, std::span<const double> inverseMasses)
{
    const std::size_t n = contacts.size();
    std::vector<double> matrix(n * n);
    double spread = 1.0; // a bound of the largest eigenvalue of the matrix, scaled to diagonal 1
    for (std::size_t i = 0; i < n; ++i) {
        double row = 0.0;
        const double own = coupling(contacts[i], contacts[i], inverseMasses);
        for (std::size_t j = 0; j < n; ++j) {
            matrix[i * n + j] = coupling(contacts[i], contacts[j], inverseMasses) / own;
            row += std::abs(matrix[i * n + j]);
        }
        contacts[i].change /= own;
        contacts[i].impulse = std::max(0.0, contacts[i].change);
        spread = std::max(spread, row);
    }
    // Alone, a contact is solved by its own equation.
    if (n < 2)
        return;

    const double relaxation = std::min(1.0, 1.9 / spread);
    std::vector<double> next(n);
    for (int round = 0; round < maxRounds; ++round) {
        double largest = 0.0;
        double moved = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            double others = 0.0;
            for (std::size_t j = 0; j < n; ++j) {
                if (j != i)
                    others += matrix[i * n + j] * contacts[j].impulse;
            }
            const double old = contacts[i].impulse;
            next[i] = std::max(0.0, old + relaxation * (contacts[i].change - others - old));
            moved = std::max(moved, std::abs(next[i] - old));
            largest = std::max(largest, next[i]);
        }
        for (std::size_t i = 0; i < n; ++i)
            contacts[i].impulse = next[i];
        if (moved <= converged * largest)
            break;
    }
}

} // namespace cradle
