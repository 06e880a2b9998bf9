// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cradle {

/// Which circles sleep, with whom, and which have been at rest for how long. Circles that lie on
/// each other sleep as one island and wake as one.
class SleepingIslands
{
public:
    /// So many circles, all of them awake.
    void start(std::size_t count);

    /// How many sleep.
    [[nodiscard]] std::size_t count() const { return m_count; }
    [[nodiscard]] bool sleeps(std::uint32_t circle) const
    {
        return m_count > 0 && m_islandOf[circle] != awake;
    }

    /// Counts a step after which a circle is at \p place (m), and slow or not. \return for how many
    /// in a row it now has been slow and no farther than \p reach (m) from where it was when that
    /// began, at most 255
    int countStill(std::uint32_t circle, bool slow, Vec2 place, double reach);
    /// Lays circles that are awake to sleep, as one island.
    void lay(std::span<const std::uint32_t> circles);
    /// Wakes the island of a circle that sleeps. \return its circles
    std::vector<std::uint32_t> wake(std::uint32_t circle);

private:
    static constexpr std::uint32_t awake = 0xffffffffU; ///< in place of an island

    std::size_t m_count = 0;
    std::vector<std::uint32_t> m_islandOf; ///< of each circle
    std::vector<std::uint8_t> m_stillFor;  ///< of each circle, steps
    std::vector<Vec2> m_stillAt;           ///< where it was when that began, m
    std::vector<std::vector<std::uint32_t>> m_islands;
};

} // namespace cradle
