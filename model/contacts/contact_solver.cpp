// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/contact_solver.h"

#include "model/contacts/many_contacts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace cradle {

namespace {

/// A share of the largest impulse below which another round changes nothing worth having.
constexpr double converged = 1e-16;
/// Rounds before the direct solution takes over; most need under 60.
constexpr int maxRounds = 200;
/// A shortfall below this share of the largest wish is rounding.
constexpr double satisfied = 1e-13;
/// A push that gives its own contact no more than this share repeats what others do.
constexpr double repeats = 1e-11;

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
/// pivots. \param right  of all n rows \return false if they are singular
bool eliminate(std::span<const double> matrix, std::span<const double> right,
               const std::vector<std::size_t> &active, std::vector<double> &solution)
{
    const std::size_t n = right.size();
    const std::size_t m = active.size();
    std::vector<double> rows(m * (m + 1));
    const auto at = [&](std::size_t r, std::size_t c) -> double & { return rows[r * (m + 1) + c]; };
    for (std::size_t r = 0; r < m; ++r) {
        for (std::size_t c = 0; c < m; ++c)
            at(r, c) = matrix[active[r] * n + active[c]];
        at(r, m) = right[active[r]];
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

/// The search for the set of contacts that push: one after the other, who lacks most is pushed
/// until it lacks nothing, while those of the set keep what they have; whose push thereby comes to
/// an end leaves the set. A contact that only repeats what others do (in a heap that is held from
/// all sides many do) takes the place of one of them. Every push takes energy, so it ends.
/// Source: Goldfarb, Idnani: A numerically stable dual method for solving strictly convex quadratic
/// programs. Math. Program. 27 (1983) 1.
class DualActiveSet
{
public:
    DualActiveSet(std::span<const double> matrix, std::span<const double> changes)
        : m_matrix(matrix)
        , m_changes(changes)
    {
        for (const double change : changes)
            m_size = std::max(m_size, std::abs(change));
    }

    /// Begins with those that push in \p contacts, if none of them repeats the others.
    void begin(std::span<const Contact> contacts)
    {
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            if (contacts[i].impulse > 0.0)
                m_active.push_back(i);
        }
        while (eliminate(m_matrix, m_changes, m_active, m_pushes)) {
            const auto worst = std::min_element(m_pushes.begin(), m_pushes.end());
            if (worst == m_pushes.end() || *worst >= 0.0)
                return;
            m_active.erase(m_active.begin() + (worst - m_pushes.begin()));
        }
        m_active.clear();
        m_pushes.clear();
    }

    /// \return whether all is fulfilled; else it cannot be
    bool run()
    {
        const std::size_t n = m_changes.size();
        for (std::size_t steps = 0; steps < 4 * n; ++steps) {
            std::size_t worst = n;
            double most = satisfied * m_size;
            for (std::size_t i = 0; i < n; ++i) {
                if (std::find(m_active.begin(), m_active.end(), i) == m_active.end()
                    && lackOf(i) > most) {
                    worst = i;
                    most = lackOf(i);
                }
            }
            if (worst == n)
                return true;
            if (!takeIn(worst, most))
                return false;
        }
        return false;
    }

    void write(std::span<Contact> contacts) const
    {
        for (Contact &contact : contacts)
            contact.impulse = 0.0;
        for (std::size_t a = 0; a < m_active.size(); ++a)
            contacts[m_active[a]].impulse = m_pushes[a];
    }

private:
    /// What contact \p i lacks of its change.
    double lackOf(std::size_t i) const
    {
        double lack = m_changes[i];
        for (std::size_t a = 0; a < m_active.size(); ++a)
            lack -= m_matrix[i * m_changes.size() + m_active[a]] * m_pushes[a];
        return lack;
    }

    /// Pushes contact \p i, which lacks \p lack, until it lacks nothing. \return false if nothing
    /// can bring it there
    bool takeIn(std::size_t i, double lack)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const std::size_t n = m_changes.size();
        double push = 0.0;
        for (;;) {
            // What a unit push at i takes from those of the set, and gives i itself.
            std::vector<double> column(n);
            for (std::size_t k = 0; k < n; ++k)
                column[k] = m_matrix[k * n + i];
            std::vector<double> taken;
            if (!eliminate(m_matrix, column, m_active, taken))
                return false;
            double given = 1.0;
            for (std::size_t a = 0; a < m_active.size(); ++a)
                given -= m_matrix[i * n + m_active[a]] * taken[a];
            const double whole = given > repeats ? lack / given : infinity;
            double bounded = infinity;
            std::size_t first = 0;
            for (std::size_t a = 0; a < m_active.size(); ++a) {
                if (taken[a] > 0.0 && m_pushes[a] / taken[a] < bounded) {
                    bounded = m_pushes[a] / taken[a];
                    first = a;
                }
            }
            const double more = std::min(whole, bounded);
            if (more == infinity)
                return false;
            for (std::size_t a = 0; a < m_active.size(); ++a)
                m_pushes[a] = std::max(0.0, m_pushes[a] - more * taken[a]);
            push += more;
            if (whole <= bounded) {
                m_active.push_back(i);
                m_pushes.push_back(push);
                return true;
            }
            lack -= more * given;
            m_active.erase(m_active.begin() + static_cast<std::ptrdiff_t>(first));
            m_pushes.erase(m_pushes.begin() + static_cast<std::ptrdiff_t>(first));
        }
    }

    std::span<const double> m_matrix;
    std::span<const double> m_changes;
    double m_size = 0.0;               ///< of the largest change
    std::vector<std::size_t> m_active; ///< the set
    std::vector<double> m_pushes;      ///< of each in it
};

} // namespace

void solveContacts(std::span<Contact> contacts, std::span<const double> inverseMasses)
{
    const std::size_t n = contacts.size();
    if (n > few) {
        solveManyContacts(contacts, inverseMasses);
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
    // Long chains converge slowly, but from where the iteration has come, the set of contacts that
    // push is nearly right.
    std::vector<double> changes;
    for (const Contact &contact : contacts)
        changes.push_back(contact.change);
    DualActiveSet set({matrix.data(), n * n}, changes);
    set.begin(contacts);
    if (set.run())
        set.write(contacts);
}

} // namespace cradle
