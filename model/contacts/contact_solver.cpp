// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/contact_solver.h"

#include "model/contacts/many_contacts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cradle {

namespace {

/// A share of the largest impulse below which another round changes nothing worth having.
constexpr double converged = 1e-16;
/// Rounds before the direct solution takes over; most need under 60.
constexpr int maxRounds = 200;
/// A shortfall below this share of the largest wish is rounding.
constexpr double satisfied = 1e-13;

/// Up to so many contacts, the matrix is written down and finished by elimination, O(n³).
constexpr std::size_t few = 64;

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

/// Solves the rows and columns of \p matrix (n × n) that \p active names, by elimination with
/// pivots. \return false if they are singular
bool eliminate(std::span<const double> matrix, std::size_t n, std::span<const Contact> contacts,
               const std::vector<std::size_t> &active, std::vector<double> &solution)
{
    const std::size_t m = active.size();
    std::vector<double> rows(m * (m + 1));
    const auto at = [&](std::size_t r, std::size_t c) -> double & { return rows[r * (m + 1) + c]; };
    for (std::size_t r = 0; r < m; ++r) {
        for (std::size_t c = 0; c < m; ++c)
            at(r, c) = matrix[active[r] * n + active[c]];
        at(r, m) = contacts[active[r]].change;
    }
    for (std::size_t c = 0; c < m; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < m; ++r)
            pivot = std::abs(at(r, c)) > std::abs(at(pivot, c)) ? r : pivot;
        if (std::abs(at(pivot, c)) < satisfied)
            return false;
        for (std::size_t k = c; k <= m; ++k)
            std::swap(at(pivot, k), at(c, k));
        for (std::size_t r = c + 1; r < m; ++r) {
            const double factor = at(r, c) / at(c, c);
            for (std::size_t k = c; k <= m; ++k)
                at(r, k) -= factor * at(c, k);
        }
    }
    solution.assign(m, 0.0);
    for (std::size_t r = m; r-- > 0;) {
        double sum = at(r, m);
        for (std::size_t c = r + 1; c < m; ++c)
            sum -= at(r, c) * solution[c];
        solution[r] = sum / at(r, r);
    }
    return true;
}

/// Long chains converge slowly; from where the iteration has come, the set of contacts that push
/// is nearly right, and a few exchanges find it. Leaves the impulses as they are if it fails.
void finishDirectly(std::span<const double> matrix, std::span<Contact> contacts)
{
    const std::size_t n = contacts.size();
    std::vector<std::size_t> active;
    double wish = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        if (contacts[i].impulse > 0.0)
            active.push_back(i);
        wish = std::max(wish, std::abs(contacts[i].change));
    }
    std::vector<double> solution;
    for (std::size_t exchange = 0; exchange < 4 * n; ++exchange) {
        if (!eliminate(matrix, n, contacts, active, solution))
            return;
        const auto worst = std::min_element(solution.begin(), solution.end());
        if (worst != solution.end() && *worst < 0.0) {
            active.erase(active.begin() + (worst - solution.begin()));
            continue;
        }
        std::vector<double> impulses(n, 0.0);
        for (std::size_t a = 0; a < active.size(); ++a)
            impulses[active[a]] = solution[a];
        std::size_t missing = n;
        double least = -satisfied * wish;
        for (std::size_t i = 0; i < n; ++i) {
            double surplus = -contacts[i].change;
            for (std::size_t j = 0; j < n; ++j)
                surplus += matrix[i * n + j] * impulses[j];
            const bool isActive = std::find(active.begin(), active.end(), i) != active.end();
            if (!isActive && surplus < least) {
                least = surplus;
                missing = i;
            }
        }
        if (missing == n) {
            for (std::size_t i = 0; i < n; ++i)
                contacts[i].impulse = impulses[i];
            return;
        }
        active.push_back(missing);
    }
}

} // namespace

void solveContacts(std::span<Contact> contacts, std::span<const double> inverseMasses,
                   int mostRounds)
{
    const std::size_t n = contacts.size();
    if (n > few) {
        solveManyContacts(contacts, inverseMasses, mostRounds);
        return;
    }
    std::array<double, few * few> matrix;
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
    std::array<double, few> next;
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
            return;
    }
    finishDirectly(matrix, contacts);
}

} // namespace cradle
