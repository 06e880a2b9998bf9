// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/pile_contacts.h"

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
    Vec2 changeA{}; ///< of the velocity of a for a push of 1 N s, m/s
    Vec2 changeB{};
    double limit = 0.0;
    double weight = 0.0; ///< by how much a push of 1 N s changes the closing speed, m/s
    double share = 0.0;  ///< 1 / weight
    double push = 0.0;
};

/// Sets one contact right after the other. \return by how much a closing speed was changed at most
template <class Iterator>
double sweep(Iterator begin, Iterator end, std::vector<Vec2> &velocities)
{
    double most = 0.0;
    for (; begin != end; ++begin) {
        Row &row = *begin;
        Vec2 &a = velocities[row.a];
        Vec2 &b = velocities[row.b];
        const double wrong = dot(a - b, row.normal) - row.limit;
        const double push = std::max(0.0, row.push + wrong * row.share);
        const double change = push - row.push;
        most = std::max(most, std::abs(change) * row.weight);
        row.push = push;
        a += change * row.changeA;
        b += change * row.changeB;
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

} // namespace

namespace {

/// Changes of all pushes, and what they do to the bodies.
struct Direction {
    std::vector<double> pushes;
    std::vector<Vec2> velocities;
    double descent = 0.0; ///< how fast the energy that is still to lose falls along it, J
};

/// Σ m v·w: how the work of one depends on the other, J.
double coupling(const Direction &v, const Direction &w, const PileBodies &bodies)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < v.velocities.size(); ++i) {
        if (bodies.inverseMasses[i] > 0.0)
            sum += dot(v.velocities[i], w.velocities[i]) / bodies.inverseMasses[i];
    }
    return sum;
}

} // namespace

int solvePile(std::span<PileContact> contacts, PileBodies &bodies, double tolerance, int mostSweeps)
{
    const std::size_t n = contacts.size();
    if (n == 0)
        return 0;
    std::vector<double> alone(n); // what is wanted of each, without any push
    for (std::size_t i = 0; i < n; ++i)
        alone[i] = closingSpeed(contacts[i], bodies) - contacts[i].limit;
    for (const PileContact &c : contacts)
        apply(c, bodies, c.push);
    std::vector<Row> rows(n);
    for (std::size_t i = 0; i < n; ++i) {
        const PileContact &c = contacts[i];
        const double weightA = bodies.inverseMasses[c.a];
        const double weightB = bodies.inverseMasses[c.b];
        rows[i] = {c.a,
                   c.b,
                   c.normal,
                   -weightA * c.normal,
                   weightB * c.normal,
                   c.limit,
                   weightA + weightB,
                   1.0 / (weightA + weightB),
                   c.push};
    }
    std::vector<double> before(n);
    std::vector<double> wanted(n);
    Direction swept{std::vector<double>(n), std::vector<Vec2>(bodies.velocities.size())};
    Direction along = swept;
    bool any = false;
    int sweeps = 0;
    while (sweeps < mostSweeps) {
        for (std::size_t i = 0; i < n; ++i) {
            const Row &row = rows[i];
            before[i] = row.push;
            wanted[i] =
                dot(bodies.velocities[row.a] - bodies.velocities[row.b], row.normal) - row.limit;
        }
        swept.velocities = bodies.velocities;
        sweep(rows.begin(), rows.end(), bodies.velocities);
        const double most = sweep(rows.rbegin(), rows.rend(), bodies.velocities);
        sweeps += 2;
        if (most <= tolerance || sweeps >= mostSweeps)
            break;
        swept.descent = along.descent = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            swept.pushes[i] = rows[i].push - before[i];
            swept.descent += wanted[i] * swept.pushes[i];
            along.descent += wanted[i] * along.pushes[i];
        }
        for (std::size_t i = 0; i < bodies.velocities.size(); ++i)
            swept.velocities[i] = bodies.velocities[i] - swept.velocities[i];
        const double zz = coupling(swept, swept, bodies);
        const double zp = any ? coupling(swept, along, bodies) : 0.0;
        const double pp = any ? coupling(along, along, bodies) : 1.0;
        const double det = zz * pp - zp * zp;
        if (!(zz > 0.0))
            break;
        double a = swept.descent / zz;
        double b = 0.0;
        if (any && det > 1e-12 * zz * pp) {
            a = (swept.descent * pp - along.descent * zp) / det;
            b = (along.descent * zz - swept.descent * zp) / det;
        }
        any = true;
        for (std::size_t i = 0; i < bodies.velocities.size(); ++i) {
            along.velocities[i] = a * swept.velocities[i] + b * along.velocities[i];
            bodies.velocities[i] += along.velocities[i] - swept.velocities[i];
        }
        for (std::size_t i = 0; i < n; ++i) {
            Row &row = rows[i];
            const double change = a * swept.pushes[i] + b * along.pushes[i];
            row.push = before[i] + change;
            along.pushes[i] = change;
            if (row.push >= 0.0)
                continue;
            const double back = -row.push; // none pulls
            row.push = 0.0;
            along.pushes[i] += back;
            along.velocities[row.a] += back * row.changeA;
            along.velocities[row.b] += back * row.changeB;
            bodies.velocities[row.a] += back * row.changeA;
            bodies.velocities[row.b] += back * row.changeB;
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        contacts[i].push = rows[i].push;
    double work = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        work += contacts[i].push * alone[i];
    scale(contacts, bodies, work);
    return sweeps;
}

} // namespace cradle
