// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/disc_grid.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace cradle {

namespace {

/// Cells a place; long and thin boxes may have up to twice as many.
constexpr double cellsPerPlace = 1.0;
/// No cell is smaller, m: places that coincide are no reason to divide by zero.
constexpr double smallest = 1e-12;

/// How many cells of \p size (m) span \p width (m), at most \p most (≥ 1).
std::uint32_t cellsAcross(double width, double size, double most)
{
    return static_cast<std::uint32_t>(std::clamp(width / size, 1.0, most));
}

/// A circle wider than this many medians is a giant, if no more than these are.
constexpr double giantSize = 4.0;
constexpr std::ptrdiff_t fewGiants = 16;

/// The least radius of a giant, m; infinite if there are none.
double giantRadius(std::span<const Circle> circles)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    if (circles.empty())
        return none;
    std::vector<double> radii;
    radii.reserve(circles.size());
    for (const Circle &c : circles)
        radii.push_back(c.radius);
    const auto median = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), median, radii.end());
    const double bound = giantSize * *median;
    const auto giants = std::count_if(median, radii.end(), [bound](double r) { return r > bound; });
    return giants <= fewGiants ? bound : none;
}

} // namespace

GiantsApart giantsApart(std::span<const Circle> circles)
{
    GiantsApart apart;
    apart.ids.resize(circles.size());
    std::iota(apart.ids.begin(), apart.ids.end(), 0U);
    const double bound = giantRadius(circles);
    const auto giants = std::stable_partition(apart.ids.begin(), apart.ids.end(),
                                              [&](auto id) { return circles[id].radius <= bound; });
    apart.small = static_cast<std::size_t>(giants - apart.ids.begin());
    for (std::size_t i = 0; i < apart.small; ++i)
        apart.smallRadius = std::max(apart.smallRadius, circles[apart.ids[i]].radius);
    return apart;
}

/// Lays cells over the box from \p low to \p high for \p count places.
void DiscGrid::divide(Vec2 low, Vec2 high, std::size_t count)
{
    const Vec2 box = high - low;
    const double wanted = std::max(1.0, cellsPerPlace * static_cast<double>(count));
    const double size =
        std::max({std::sqrt(box.x * box.y / wanted), std::max(box.x, box.y) / wanted, smallest});
    m_columns = cellsAcross(box.x, size, wanted);
    m_rows = cellsAcross(box.y, size, wanted);
    m_origin = low;
    m_perCell = {box.x > 0.0 ? m_columns / box.x : 0.0, box.y > 0.0 ? m_rows / box.y : 0.0};
    m_cells.resize(count);
    m_sorted.resize(count);
    m_starts.assign(std::size_t{m_columns} * m_rows + 1, 0);
}

void DiscGrid::sort()
{
    for (const std::uint32_t cell : m_cells)
        ++m_starts[cell];
    // First the end of each cell; filling from behind then leaves its start.
    std::uint32_t end = 0;
    for (std::uint32_t &start : m_starts)
        start = end += start;
    for (std::size_t i = m_cells.size(); i-- > 0;)
        m_sorted[--m_starts[m_cells[i]]] = static_cast<std::uint32_t>(i);
}

} // namespace cradle
