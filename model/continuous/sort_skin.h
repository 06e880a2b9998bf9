// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace cradle {

/// For how many steps a sort into a grid is good: until a circle can be farther than the skin from
/// where it was sorted.
/// Source: Verlet, Computer "experiments" on classical fluids I, 1967.
class SortSkin
{
public:
    static constexpr std::size_t mostSteps = 64;

    /// Begins with a sort, for steps of \p dt s under \p gravity (its size, m/s²). The skin is
    /// \p width (m), or what the fastest circle (m/s) goes in a step if that is more.
    void start(double dt, double gravity, double width, double fastest);
    /// Takes note that after \p index steps a circle may have \p speed (m/s).
    void note(double speed, std::size_t index);

    [[nodiscard]] double width() const { return m_width; }      ///< m
    [[nodiscard]] double fastest() const { return m_fastest; }  ///< noted, m/s
    [[nodiscard]] std::size_t steps() const { return m_steps; } ///< from the sort on
    /// How far a circle of \p speed (m/s) can come in \p time s, whatever its integrator, m.
    [[nodiscard]] double travel(double time, double speed) const
    {
        return time * (speed + m_gravity * (m_dt + 0.5 * time));
    }
    /// How far at most a circle may be from where it was sorted so many steps ago, m.
    [[nodiscard]] double driftAfter(std::size_t steps) const;

private:
    double m_dt = 0.0;      ///< s
    double m_gravity = 0.0; ///< m/s²
    double m_width = 0.0;   ///< m
    double m_fastest = 0.0; ///< when m_drifted was counted, m/s
    double m_drifted = 0.0; ///< at most, by step m_driftStep, m
    std::size_t m_driftStep = 0;
    std::size_t m_steps = 0;
};

} // namespace cradle
