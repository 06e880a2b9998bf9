// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_contacts.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

void apply(const PileContact &c, PileBodies &bodies, double push)
{
    bodies.velocities[c.a] -= (push * bodies.inverseMasses[c.a]) * c.normal;
    bodies.velocities[c.b] += (push * bodies.inverseMasses[c.b]) * c.normal;
}

double closingSpeed(const PileContact &c, const PileBodies &bodies)
{
    return dot(bodies.velocities[c.a] - bodies.velocities[c.b], c.normal);
}

/// A contact as a sweep wants it: without a division, and all in one place.
struct Row {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Vec2 normal{};
    double limit = 0.0;
    double weightA = 0.0; ///< 1 / mass of a, 1/kg
    double weightB = 0.0;
    double share = 0.0; ///< the push that changes the closing speed by 1 m/s, N s
    double push = 0.0;
};

void apply(const Row &row, std::vector<Vec2> &velocities, double push)
{
    velocities[row.a] -= (push * row.weightA) * row.normal;
    velocities[row.b] += (push * row.weightB) * row.normal;
}

/// By how much the contact closes faster than it may, m/s.
double wrongOf(const Row &row, const std::vector<Vec2> &velocities)
{
    return dot(velocities[row.a] - velocities[row.b], row.normal) - row.limit;
}

/// Sets one contact right after the other. \return by how much a closing speed was changed at most
template <class Iterator>
double sweep(Iterator begin, Iterator end, std::vector<Vec2> &velocities)
{
    double most = 0.0;
    for (; begin != end; ++begin) {
        Row &row = *begin;
        const double wrong = wrongOf(row, velocities);
        const double push = std::max(0.0, row.push + wrong * row.share);
        const double change = push - row.push;
        most = std::max(most, std::abs(change) * (row.weightA + row.weightB));
        row.push = push;
        apply(row, velocities, change);
    }
    return most;
}

/// Makes the pushes do no work against what they leave undone.
void scale(std::span<PileContact> contacts, PileBodies &bodies, double work)
{
    // The work of what is undone, J·(closing − limit), and what a larger push would take of it.
    double undone = 0.0;
    for (const PileContact &c : contacts)
        undone += c.push * (closingSpeed(c, bodies) - c.limit);
    const double taken = work - undone;
    if (!(taken > 0.0))
        return;
    const double share = undone / taken;
    for (PileContact &c : contacts) {
        apply(c, bodies, share * c.push);
        c.push *= 1.0 + share;
    }
}

/// In which order the sweeps go through the contacts: roughly theirs. Those of one body stand side
/// by side, and each would wait for the one before it; so every few of them are dealt out in turn.
std::vector<std::uint32_t> orderOf(std::size_t count)
{
    constexpr std::size_t hands = 8;
    constexpr std::size_t cards = 8;
    std::vector<std::uint32_t> order;
    order.reserve(count);
    for (std::size_t begin = 0; begin < count; begin += hands * cards) {
        const std::size_t end = std::min(count, begin + hands * cards);
        for (std::size_t hand = 0; hand < cards; ++hand) {
            for (std::size_t i = begin + hand; i < end; i += cards)
                order.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return order;
}

std::vector<Row> rowsOf(std::span<const PileContact> contacts, std::span<const std::uint32_t> order,
                        const PileBodies &bodies)
{
    std::vector<Row> rows;
    rows.reserve(contacts.size());
    for (const std::uint32_t i : order) {
        const PileContact &c = contacts[i];
        const double weightA = bodies.inverseMasses[c.a];
        const double weightB = bodies.inverseMasses[c.b];
        rows.push_back(
            {c.a, c.b, c.normal, c.limit, weightA, weightB, 1.0 / (weightA + weightB), c.push});
    }
    return rows;
}

/// The search for the pushes: sweeps, and after each two of them a step along the best combination
/// of what they changed and the step before, as conjugate gradients take it.
class Descent
{
public:
    Descent(std::vector<Row> &rows, PileBodies &bodies)
        : m_rows(rows)
        , m_velocities(bodies.velocities)
        , m_wrong(rows.size())
        , m_before(rows.size())
        , m_along(rows.size(), 0.0)
        , m_start(bodies.velocities.size())
        , m_alongVelocities(bodies.velocities.size())
    {
        for (const double inverse : bodies.inverseMasses)
            m_masses.push_back(inverse > 0.0 ? 1.0 / inverse : 0.0);
    }

    /// \return how many sweeps it took
    int run(double tolerance, int mostSweeps)
    {
        for (int sweeps = 2;; sweeps += 2) {
            m_start = m_velocities;
            for (std::size_t i = 0; i < m_rows.size(); ++i) {
                m_before[i] = m_rows[i].push;
                m_wrong[i] = wrongOf(m_rows[i], m_velocities);
            }
            sweep(m_rows.begin(), m_rows.end(), m_velocities);
            const double most = sweep(m_rows.rbegin(), m_rows.rend(), m_velocities);
            if (most <= tolerance || sweeps >= mostSweeps || !stepAlong())
                return sweeps;
        }
    }

private:
    /// \return false if the sweeps changed nothing
    bool stepAlong()
    {
        // How fast the energy that is still to lose falls along both directions, and how the work
        // of one depends on the other, J.
        double fallSwept = 0.0;
        double fallAlong = 0.0;
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            fallSwept += m_wrong[i] * (m_rows[i].push - m_before[i]);
            fallAlong += m_wrong[i] * m_along[i];
        }
        double zz = 0.0;
        double zp = 0.0;
        double pp = 0.0;
        for (std::size_t i = 0; i < m_masses.size(); ++i) {
            const Vec2 z = m_velocities[i] - m_start[i];
            const Vec2 p = m_alongVelocities[i];
            zz += m_masses[i] * dot(z, z);
            zp += m_masses[i] * dot(z, p);
            pp += m_masses[i] * dot(p, p);
        }
        if (!(zz > 0.0))
            return false;
        const double det = zz * pp - zp * zp;
        double a = fallSwept / zz;
        double b = 0.0;
        if (det > 1e-12 * zz * pp) {
            a = (fallSwept * pp - fallAlong * zp) / det;
            b = (fallAlong * zz - fallSwept * zp) / det;
        }
        for (std::size_t i = 0; i < m_masses.size(); ++i) {
            m_alongVelocities[i] = a * (m_velocities[i] - m_start[i]) + b * m_alongVelocities[i];
            m_velocities[i] = m_start[i] + m_alongVelocities[i];
        }
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            Row &row = m_rows[i];
            m_along[i] = a * (row.push - m_before[i]) + b * m_along[i];
            row.push = m_before[i] + m_along[i];
            if (row.push >= 0.0)
                continue;
            const double back = -row.push; // none pulls
            row.push = 0.0;
            m_along[i] += back;
            apply(row, m_alongVelocities, back);
            apply(row, m_velocities, back);
        }
        return true;
    }

    std::vector<Row> &m_rows;
    std::vector<Vec2> &m_velocities;
    std::vector<double> m_masses;        ///< kg, 0 for walls
    std::vector<double> m_wrong;         ///< closing speeds too many before the sweeps, m/s
    std::vector<double> m_before;        ///< pushes then
    std::vector<double> m_along;         ///< what the latest step changed of the pushes,
    std::vector<Vec2> m_start;           ///< velocities then
    std::vector<Vec2> m_alongVelocities; ///< and of the velocities
};

} // namespace

int solvePile(std::span<PileContact> contacts, PileBodies &bodies, double tolerance, int mostSweeps)
{
    if (contacts.empty())
        return 0;
    std::vector<double> alone; // what is wanted of each, without any push
    alone.reserve(contacts.size());
    for (const PileContact &c : contacts)
        alone.push_back(closingSpeed(c, bodies) - c.limit);
    for (const PileContact &c : contacts)
        apply(c, bodies, c.push);
    const std::vector<std::uint32_t> order = orderOf(contacts.size());
    std::vector<Row> rows = rowsOf(contacts, order, bodies);
    const int sweeps = Descent(rows, bodies).run(tolerance, mostSweeps);
    double work = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        contacts[order[i]].push = rows[i].push;
        work += rows[i].push * alone[order[i]];
    }
    scale(contacts, bodies, work);
    return sweeps;
}

} // namespace cradle
