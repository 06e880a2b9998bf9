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

/// A contact as a sweep wants it: without a division, and all on one line of the cache.
struct Row {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Vec2 normal{};
    double limit = 0.0;
    double share = 0.0;  ///< the push that changes the closing speed by 1 m/s, N s
    double push = 0.0;   ///< N s
    double before = 0.0; ///< the push before the latest two sweeps
    double along = 0.0;  ///< what the latest step changed of it
};

std::vector<Row> rowsOf(std::span<const PileContact> contacts, std::span<const std::uint32_t> order,
                        const std::vector<double> &inverseMasses)
{
    std::vector<Row> rows;
    rows.reserve(contacts.size());
    for (const std::uint32_t i : order) {
        const PileContact &c = contacts[i];
        const double share = 1.0 / (inverseMasses[c.a] + inverseMasses[c.b]);
        rows.push_back({c.a, c.b, c.normal, c.limit, share, c.push, c.push, 0.0});
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
        , m_weights(bodies.inverseMasses)
        , m_start(bodies.velocities.size())
        , m_along(bodies.velocities.size())
    {
        m_masses.reserve(m_weights.size());
        for (const double inverse : m_weights)
            m_masses.push_back(inverse > 0.0 ? 1.0 / inverse : 0.0);
    }

    /// \return how many sweeps it took
    int run(double tolerance, int mostSweeps)
    {
        double fallAlong = 0.0;
        for (int sweeps = 2;; sweeps += 2) {
            m_start = m_velocities;
            double lost = 0.0;
            for (Row &row : m_rows) {
                row.before = row.push;
                lost += setRight(row).lost;
            }
            double most = 0.0;
            for (auto row = m_rows.rbegin(); row != m_rows.rend(); ++row) {
                const Change change = setRight(*row);
                lost += change.lost;
                most = std::max(most, std::abs(change.speed));
            }
            if (most <= tolerance || sweeps >= mostSweeps || !stepAlong(lost, fallAlong))
                return sweeps;
        }
    }

private:
    struct Change {
        double speed = 0.0; ///< by which the closing speed falls, m/s
        double lost = 0.0;  ///< of the energy that is to be as small as it can, J
    };

    void apply(const Row &row, std::vector<Vec2> &velocities, double push) const
    {
        velocities[row.a] -= (push * m_weights[row.a]) * row.normal;
        velocities[row.b] += (push * m_weights[row.b]) * row.normal;
    }

    static double closingSpeed(const Row &row, const std::vector<Vec2> &velocities)
    {
        return dot(velocities[row.a] - velocities[row.b], row.normal);
    }

    /// Sets one contact right, whatever that does to others.
    Change setRight(Row &row)
    {
        const double wrong = closingSpeed(row, m_velocities) - row.limit;
        const double push = std::max(0.0, row.push + wrong * row.share);
        const double change = push - row.push;
        row.push = push;
        apply(row, m_velocities, change);
        const double speed = change * (m_weights[row.a] + m_weights[row.b]);
        return {speed, change * (wrong - 0.5 * speed)};
    }

    /// Goes to the least energy among all combinations of what the sweeps changed and of the step
    /// before; none may pull.
    /// \param lost  in the sweeps, J
    /// \param fallAlong  how fast the energy falls along the step before, J; then along this one
    /// \return false if the sweeps changed nothing
    bool stepAlong(double lost, double &fallAlong)
    {
        double zz = 0.0; // works of the changes on each other
        double zp = 0.0;
        double pp = 0.0;
        for (std::size_t i = 0; i < m_masses.size(); ++i) {
            const Vec2 z = m_velocities[i] - m_start[i];
            const Vec2 p = m_along[i];
            zz += m_masses[i] * dot(z, z);
            zp += m_masses[i] * dot(z, p);
            pp += m_masses[i] * dot(p, p);
        }
        if (!(zz > 0.0))
            return false;
        const double fallSwept = lost + 0.5 * zz;
        const double det = zz * pp - zp * zp;
        double a = fallSwept / zz;
        double b = 0.0;
        if (det > 1e-12 * zz * pp) {
            a = (fallSwept * pp - fallAlong * zp) / det;
            b = (fallAlong * zz - fallSwept * zp) / det;
        }
        for (std::size_t i = 0; i < m_masses.size(); ++i) {
            m_along[i] = a * (m_velocities[i] - m_start[i]) + b * m_along[i];
            m_velocities[i] = m_start[i] + m_along[i];
        }
        fallAlong = 0.0; // but for what does not pull
        for (Row &row : m_rows) {
            row.along = a * (row.push - row.before) + b * row.along;
            row.push = row.before + row.along;
            if (row.push >= 0.0)
                continue;
            const double back = -row.push;
            fallAlong += back
                         * (closingSpeed(row, m_velocities) - row.limit + closingSpeed(row, m_along)
                            - back / row.share);
            row.push = 0.0;
            row.along += back;
            apply(row, m_along, back);
            apply(row, m_velocities, back);
        }
        return true;
    }

    std::vector<Row> &m_rows;
    std::vector<Vec2> &m_velocities;
    const std::vector<double> &m_weights; ///< inverse masses, 1/kg
    std::vector<double> m_masses;         ///< kg, 0 for walls
    std::vector<Vec2> m_start;            ///< velocities before the latest two sweeps
    std::vector<Vec2> m_along;            ///< what the latest step changed of them
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
    std::vector<Row> rows = rowsOf(contacts, order, bodies.inverseMasses);
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
