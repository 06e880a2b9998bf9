// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/substeps.h"

#include <cmath>

namespace cradle {

namespace {

/// In how many equal parts of a step the drift of one or the other Euler is \p share of a Δt².
std::optional<int> substepsOf(double share)
{
    constexpr double most = 1000.0;
    const double parts = 0.5 / std::abs(share - 0.5);
    const bool isWhole = std::abs(parts - std::round(parts)) < 1e-4 * parts;
    return parts < most && isWhole ? std::optional(static_cast<int>(std::round(parts)))
                                   : std::nullopt;
}

} // namespace

bool Substeps::take(const Observation &o, int i, qint64 k, Vec2 gravity, double tolerance)
{
    const double h = o.timestep();
    const Circle &now = o.circle(i, k);
    const Vec2 drift = o.circle(i, k + 1).position - now.position - h * now.velocity;
    const Vec2 fall = h * h * gravity;
    if (!m_share) {
        m_share = lengthSquared(fall) > 0.0 ? dot(drift, fall) / lengthSquared(fall) : 0.0;
        if (const auto parts = substepsOf(*m_share)) {
            const double side = *m_share < 0.5 ? -0.5 : 0.5;
            m_share = 0.5 + side / *parts;
        } else {
            m_isOne = false;
        }
    }
    m_isOne =
        m_isOne
        && quickLength(drift - *m_share * fall) <= tolerance * (1.0 + quickLength(now.position));
    return m_isOne;
}

} // namespace cradle
