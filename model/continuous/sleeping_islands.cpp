// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/sleeping_islands.h"

#include <algorithm>
#include <utility>

namespace cradle {

void SleepingIslands::start(std::size_t count)
{
    m_count = 0;
    m_islandOf.assign(count, awake);
    m_stillFor.assign(count, 0);
    m_stillAt.assign(count, Vec2{});
    m_islands.clear();
}

int SleepingIslands::countStill(std::uint32_t circle, bool slow, Vec2 place, double reach)
{
    constexpr int most = 255;
    std::uint8_t &steps = m_stillFor[circle];
    Vec2 &start = m_stillAt[circle];
    if (!slow || steps == 0 || lengthSquared(place - start) > reach * reach) {
        start = place;
        steps = slow ? 1 : 0;
    } else {
        steps = static_cast<std::uint8_t>(std::min(steps + 1, most));
    }
    return steps;
}

void SleepingIslands::lay(std::span<const std::uint32_t> circles)
{
    for (const std::uint32_t circle : circles)
        m_islandOf[circle] = static_cast<std::uint32_t>(m_islands.size());
    m_islands.emplace_back(circles.begin(), circles.end());
    m_count += circles.size();
}

std::vector<std::uint32_t> SleepingIslands::wake(std::uint32_t circle)
{
    std::vector<std::uint32_t> circles = std::exchange(m_islands[m_islandOf[circle]], {});
    for (const std::uint32_t other : circles) {
        m_islandOf[other] = awake;
        m_stillFor[other] = 0;
    }
    m_count -= circles.size();
    if (m_count == 0)
        m_islands.clear();
    return circles;
}

} // namespace cradle
