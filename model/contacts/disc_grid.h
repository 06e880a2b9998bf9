// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/circle.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cradle {

/// Circles parted into those that a grid suits and a few giants, which are better looked at one by
/// one: a grid for them would be far too coarse for the others.
struct GiantsApart {
    std::vector<std::uint32_t> ids; ///< of all circles, the giants last, else in their order
    std::size_t small = 0;          ///< so many are no giants
    double smallRadius = 0.0;       ///< the largest of those, m
};
[[nodiscard]] GiantsApart giantsApart(std::span<const Circle> circles);

/// A uniform grid over places, about one place a cell, filled by counting sort. Whoever builds it
/// keeps its things in the order of sorted(): then the things of neighbouring cells of a row lie
/// side by side in memory, and a box of the plane is a few runs of them.
class DiscGrid
{
public:
    /// Sorts \p count places into cells; placeOf(i) is the i-th, m. The box of the grid is theirs.
    template <class PlaceOf>
    void build(std::size_t count, PlaceOf placeOf)
    {
        Vec2 low = count > 0 ? placeOf(0) : Vec2{};
        Vec2 high = low;
        for (std::size_t i = 1; i < count; ++i) {
            const Vec2 p = placeOf(i);
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        divide(low, high, count);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 p = placeOf(i);
            m_cells[i] = row(p.y) * m_columns + column(p.x);
        }
        sort();
    }

    /// The index into the places of the one that comes at \p slot in the sorted order.
    [[nodiscard]] std::span<const std::uint32_t> sorted() const { return m_sorted; }

    /// Calls visit(begin, end) for runs of slots that together hold every place no farther than
    /// \p reach (m) from \p centre along each axis, and some others.
    template <class Visit>
    void visitRuns(Vec2 centre, double reach, Visit visit) const
    {
        const std::uint32_t left = column(centre.x - reach);
        const std::uint32_t right = column(centre.x + reach);
        const std::uint32_t top = row(centre.y + reach);
        for (std::uint32_t y = row(centre.y - reach); y <= top; ++y) {
            const std::size_t line = std::size_t{y} * m_columns;
            visit(m_starts[line + left], m_starts[line + right + 1]);
        }
    }

    /// The same for those that come after \p slot, which lies at \p centre: over all slots every
    /// pair is seen once.
    template <class Visit>
    void visitRunsAfter(std::uint32_t slot, Vec2 centre, double reach, Visit visit) const
    {
        const std::uint32_t left = column(centre.x - reach);
        const std::uint32_t right = column(centre.x + reach);
        const std::uint32_t top = row(centre.y + reach);
        std::size_t line = std::size_t{row(centre.y)} * m_columns;
        visit(slot + 1, m_starts[line + right + 1]);
        for (std::uint32_t y = row(centre.y) + 1; y <= top; ++y) {
            line += m_columns;
            visit(m_starts[line + left], m_starts[line + right + 1]);
        }
    }

private:
    void divide(Vec2 low, Vec2 high, std::size_t count);
    void sort();
    [[nodiscard]] std::uint32_t column(double x) const
    {
        return cellOf((x - m_origin.x) * m_perCell.x, m_columns);
    }
    [[nodiscard]] std::uint32_t row(double y) const
    {
        return cellOf((y - m_origin.y) * m_perCell.y, m_rows);
    }
    static std::uint32_t cellOf(double place, std::uint32_t count)
    {
        return static_cast<std::uint32_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
    }

    Vec2 m_origin{};  ///< the lower left corner, m
    Vec2 m_perCell{}; ///< 1 / width and 1 / height of a cell, 1/m
    std::uint32_t m_columns = 1;
    std::uint32_t m_rows = 1;
    std::vector<std::uint32_t> m_starts{0, 0}; ///< first slot of each cell, row by row, and the end
    std::vector<std::uint32_t> m_sorted;
    std::vector<std::uint32_t> m_cells; ///< of each place
};

} // namespace cradle
