// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

    /// Counts a step in which a circle was at rest, or was not. \return for how many it now has
    /// been in a row, at most 255
    int countStill(std::uint32_t circle, bool still);
    /// Lays circles that are awake to sleep, as one island.
    void lay(std::span<const std::uint32_t> circles);
    /// Wakes the island of a circle that sleeps. \return its circles
    std::vector<std::uint32_t> wake(std::uint32_t circle);

private:
    static constexpr std::uint32_t awake = 0xffffffffU; ///< in place of an island

    std::size_t m_count = 0;
    std::vector<std::uint32_t> m_islandOf; ///< of each circle
    std::vector<std::uint8_t> m_stillFor;  ///< of each circle, steps
    std::vector<std::vector<std::uint32_t>> m_islands;
};

} // namespace cradle
