// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/cell_lists.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Cells a thing. More are left more often, fewer list more things that are not near.
constexpr double cellsPerThing = 2.5;
/// A reach is so many cells wide at most: where it is wider than things are apart, few large cells
/// are looked at faster than many small ones.
constexpr double widestReach = 2.0;
/// A reach is longer by this share, so that rounding cannot hide what is right at its end.
constexpr double margin = 1e-9;
/// No cell is smaller, m: places that coincide are no reason to divide by zero.
constexpr double smallest = 1e-12;

std::uint32_t cellsAcross(double width, double size, double most)
{
    return static_cast<std::uint32_t>(std::clamp(width / size, 1.0, std::max(1.0, most)));
}

} // namespace

void CellLists::divide(Vec2 low, Vec2 high, std::size_t count, double reach)
{
    const Vec2 box = high - low;
    const double wanted = std::max(1.0, cellsPerThing * static_cast<double>(count));
    const double even =
        std::max({std::sqrt(box.x * box.y / wanted), std::max(box.x, box.y) / wanted, smallest});
    reach *= 1.0 + margin;
    const double ring = std::clamp(std::ceil(reach / even), 1.0, widestReach);
    const double size = std::max(even, reach / ring);
    m_ring = static_cast<std::uint32_t>(ring);
    m_columns = cellsAcross(box.x, size, wanted);
    m_rows = cellsAcross(box.y, size, wanted);
    m_stride = std::size_t{m_columns} + 2 * m_ring;
    m_low = low;
    m_size = {box.x / m_columns, box.y / m_rows};
    m_heads.assign(m_stride * (std::size_t{m_rows} + 2 * m_ring), none);
}

std::uint32_t CellLists::cellOf(double place, std::uint32_t count)
{
    // Not a number where the box has no width.
    return place > 0.0 ? static_cast<std::uint32_t>(std::min(place, count - 1.0)) : 0;
}

} // namespace cradle
