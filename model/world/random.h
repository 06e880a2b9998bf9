// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <QtGlobal>

#include <numbers>
#include <random>

namespace cradle {

/// Random numbers that are the same with every standard library, for a given seed.
class Random
{
public:
    explicit Random(qint64 seed)
        : m_engine(static_cast<std::uint64_t>(seed))
    {
    }

    /// Evenly from 0 up to, but not including, 1.
    double uniform() { return static_cast<double>(m_engine() >> 11U) * 0x1p-53; }
    /// Evenly from \p low to \p high.
    double between(double low, double high) { return low + (high - low) * uniform(); }
    /// Evenly one of 0 … n − 1.
    std::size_t below(std::size_t n) { return m_engine() % n; }
    /// Two independent standard Gaussians (Box and Muller).
    Vec2 gaussian()
    {
        const double r = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        const double angle = 2.0 * std::numbers::pi * uniform();
        return {r * std::cos(angle), r * std::sin(angle)};
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace cradle
