// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/many_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace cradle {

namespace {

/// A share of the largest wish that may be left undone: far below what counts as rest.
constexpr double endOfRounds = 1e-9;
/// Rounds after which it stops: some times what the longest chains need. Elastic heaps that are
/// held from many sides converge slowly; after so many one of 1,000 overlaps by 0.03 radii, one of
/// 300 by 0.001.
constexpr int mostRoundsOfMany = 4000;

std::size_t indexOf(int body)
{
    return static_cast<std::size_t>(body);
}

/// A bound of the largest eigenvalue of the matrix that is scaled to diagonal 1: of its sums of
/// rows. \p own receives the diagonal before.
double spreadOf(std::span<const Contact> contacts, std::span<const double> inverseMasses,
                std::vector<double> &own)
{
    std::vector<std::vector<std::uint32_t>> touching(inverseMasses.size());
    for (std::uint32_t i = 0; i < contacts.size(); ++i) {
        touching[indexOf(contacts[i].a)].push_back(i);
        if (contacts[i].b >= 0)
            touching[indexOf(contacts[i].b)].push_back(i);
    }
    double spread = 1.0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        own[i] = inverseMasses[indexOf(contacts[i].a)];
        if (contacts[i].b >= 0)
            own[i] += inverseMasses[indexOf(contacts[i].b)];
        double row = 0.0;
        for (const int body : {contacts[i].a, contacts[i].b}) {
            if (body < 0)
                continue;
            for (const std::uint32_t j : touching[indexOf(body)])
                row += inverseMasses[indexOf(body)]
                       * std::abs(dot(contacts[i].normal, contacts[j].normal));
        }
        spread = std::max(spread, row / own[i]);
    }
    return spread;
}

/// The product of the matrix, scaled to diagonal 1, with a vector: in O(n), by way of the changes
/// of the bodies' velocities. \p normals are those of the contacts, scaled.
class ScaledMatrix
{
public:
    ScaledMatrix(std::span<const Contact> contacts, std::span<const double> inverseMasses,
                 std::span<const Vec2> normals)
        : m_contacts(contacts)
        , m_inverseMasses(inverseMasses)
        , m_normals(normals)
        , m_velocities(inverseMasses.size())
    {
    }
    void multiply(const std::vector<double> &x, std::vector<double> &product)
    {
        std::fill(m_velocities.begin(), m_velocities.end(), Vec2{});
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Vec2 impulse = x[i] * m_normals[i];
            const Contact &c = m_contacts[i];
            m_velocities[indexOf(c.a)] += m_inverseMasses[indexOf(c.a)] * impulse;
            if (c.b >= 0)
                m_velocities[indexOf(c.b)] -= m_inverseMasses[indexOf(c.b)] * impulse;
        }
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Contact &c = m_contacts[i];
            const Vec2 other = c.b < 0 ? Vec2{} : m_velocities[indexOf(c.b)];
            product[i] = dot(m_velocities[indexOf(c.a)] - other, m_normals[i]);
        }
    }

private:
    std::span<const Contact> m_contacts;
    std::span<const double> m_inverseMasses;
    std::span<const Vec2> m_normals;
    std::vector<Vec2> m_velocities;
};

/// x·y, in four sums side by side.
double product(const std::vector<double> &x, const std::vector<double> &y)
{
    std::array<double, 4> sums{};
    const std::size_t whole = x.size() - x.size() % 4;
    for (std::size_t i = 0; i < whole; i += 4) {
        for (std::size_t k = 0; k < 4; ++k)
            sums[k] += x[i + k] * y[i + k];
    }
    for (std::size_t i = whole; i < x.size(); ++i)
        sums[0] += x[i] * y[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

void solveManyContacts(std::span<Contact> contacts, std::span<const double> inverseMasses)
{
    const std::size_t n = contacts.size();
    std::vector<double> scale(n);
    const double step = 1.9 / spreadOf(contacts, inverseMasses, scale);
    std::vector<Vec2> normals(n);
    double wish = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        scale[i] = 1.0 / std::sqrt(scale[i]);
        normals[i] = scale[i] * contacts[i].normal;
        wish = std::max(wish, scale[i] * contacts[i].change);
    }
    ScaledMatrix matrix(contacts, inverseMasses, normals);
    std::vector<double> x(n);
    std::vector<double> gradient(n); // of ½ x·A x − change·x
    std::vector<double> free(n);     // its part where x > 0
    std::vector<double> chopped(n);  // its part that asks for a push where x = 0
    std::vector<double> along(n);
    std::vector<double> change(n); // A along
    const auto move = [&](const std::vector<double> &direction, double length) {
        for (std::size_t i = 0; i < n; ++i) {
            x[i] = std::max(0.0, x[i] - length * direction[i]);
            gradient[i] -= length * change[i];
        }
    };
    const auto split = [&] {
        double most = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            free[i] = x[i] > 0.0 ? gradient[i] : 0.0;
            chopped[i] = x[i] > 0.0 ? 0.0 : std::min(0.0, gradient[i]);
            most = std::max(most, std::abs(free[i] + chopped[i]));
        }
        return most;
    };
    const auto restart = [&] {
        matrix.multiply(x, gradient);
        for (std::size_t i = 0; i < n; ++i)
            gradient[i] -= scale[i] * contacts[i].change;
    };
    restart();
    double wrong = split();
    along = free;
    for (int round = 0; round < mostRoundsOfMany && wrong > endOfRounds * wish; ++round) {
        if (product(chopped, chopped) > product(free, free)) {
            matrix.multiply(chopped, change);
            move(chopped, product(gradient, chopped) / product(chopped, change));
            wrong = split();
            along = free;
            continue;
        }
        matrix.multiply(along, change);
        const double curvature = product(along, change);
        const double whole = product(gradient, along) / curvature;
        double feasible = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < n; ++i) {
            if (along[i] > 0.0)
                feasible = std::min(feasible, x[i] / along[i]);
        }
        if (whole <= feasible) {
            move(along, whole);
            wrong = split();
            const double turn = product(free, change) / curvature;
            for (std::size_t i = 0; i < n; ++i)
                along[i] = free[i] - turn * along[i];
            continue;
        }
        move(along, feasible);
        split();
        move(free, step);
        restart();
        wrong = split();
        along = free;
    }
    for (std::size_t i = 0; i < n; ++i)
        contacts[i].impulse = scale[i] * x[i];
}

} // namespace cradle
