// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace cradle {

/// Where a thing is listed.
struct CellLink {
    std::uint32_t next = 0; ///< in the same cell, or none
    std::uint32_t previous = 0;
    std::uint32_t column = 0;
    std::uint32_t row = 0;
};

/// Which things are listed in which cell of a grid over the plane; a thing moves from cell to cell
/// one at a time, whenever its owner says so. Cells at the edge reach outwards without end.
/// The things are the owner's array, given to each call: each has a CellLink `link`, which so lies
/// beside what else is read of it.
class CellLists
{
public:
    using Slot = std::uint32_t;

    /// Lays cells over the box from \p low to \p high (m) for about \p count things; none is listed
    /// yet. Those that near() names are all that may be within \p reach (m) along each axis.
    void divide(Vec2 low, Vec2 high, std::size_t count, double reach);

    /// Lists \p slot, which was not listed, in the cell at \p place (m).
    template <class Thing>
    void insert(Thing *things, Slot slot, Vec2 place)
    {
        things[slot].link.column = cellOf((place.x - m_low.x) / m_size.x, m_columns);
        things[slot].link.row = cellOf((place.y - m_low.y) / m_size.y, m_rows);
        enter(things, slot);
    }

    /// Lists \p slot in the next cell towards \p side; it is not at that edge.
    template <class Thing>
    void move(Thing *things, Slot slot, Wall side)
    {
        CellLink &link = things[slot].link;
        (link.previous != none ? things[link.previous].link.next : m_heads[indexOf(link)]) =
            link.next;
        if (link.next != none)
            things[link.next].link.previous = link.previous;
        if (side == Wall::Left || side == Wall::Right)
            link.column += side == Wall::Right ? 1U : ~0U;
        else
            link.row += side == Wall::Top ? 1U : ~0U;
        enter(things, slot);
    }

    /// Where the cell of \p link ends to the left or right, m; ±infinity at the edge of the grid.
    [[nodiscard]] double endAcross(const CellLink &link, bool right) const
    {
        return endOf(link.column, right, m_columns, m_low.x, m_size.x);
    }
    /// The same below or above.
    [[nodiscard]] double endAlong(const CellLink &link, bool top) const
    {
        return endOf(link.row, top, m_rows, m_low.y, m_size.y);
    }
    /// Bit w is set if the cell of \p link is at the edge towards Wall w.
    [[nodiscard]] unsigned edgesOf(const CellLink &link) const
    {
        return bit(Wall::Left, link.column == 0) | bit(Wall::Right, link.column + 1 == m_columns)
               | bit(Wall::Bottom, link.row == 0) | bit(Wall::Top, link.row + 1 == m_rows);
    }

    /// All others within reach of \p slot into \p found, which has room for all things and one
    /// more. \return how many
    template <class Thing>
    std::size_t near(const Thing *things, Slot slot, Slot *found) const
    {
        const CellLink &own = things[slot].link;
        std::size_t count = 0;
        // Those of its own cell come before it or follow it.
        for (Slot before = own.previous; before != none; before = things[before].link.previous)
            found[count++] = before;
        const std::size_t before = count;
        count = append(own.next, found, count);
        const Slot *here = &m_heads[indexOf(own)];
        const auto ring = static_cast<std::ptrdiff_t>(m_ring);
        const auto stride = static_cast<std::ptrdiff_t>(m_stride);
        for (std::ptrdiff_t row = -ring; row <= ring; ++row) {
            const Slot *line = here + row * stride;
            for (std::ptrdiff_t column = 1; column <= ring; ++column) {
                count = append(line[-column], found, count);
                count = append(line[column], found, count);
            }
            if (row != 0)
                count = append(*line, found, count);
        }
        return before + follow(things, found + before, count - before);
    }

    /// Of these only those that came into reach when \p slot moved towards \p side.
    template <class Thing>
    std::size_t ahead(const Thing *things, Slot slot, Wall side, Slot *found) const
    {
        const auto ring = static_cast<std::ptrdiff_t>(m_ring);
        const auto stride = static_cast<std::ptrdiff_t>(m_stride);
        const bool across = side == Wall::Left || side == Wall::Right;
        const bool forth = side == Wall::Right || side == Wall::Top;
        const std::ptrdiff_t step = across ? 1 : stride;
        const Slot *front =
            &m_heads[indexOf(things[slot].link)] + (forth ? ring * step : -ring * step);
        std::size_t count = 0;
        for (std::ptrdiff_t along = -ring; along <= ring; ++along)
            count = append(front[along * (stride + 1 - step)], found, count);
        return follow(things, found, count);
    }

    /// All that may be between \p low and \p high (m).
    template <class Thing>
    std::size_t within(const Thing *things, Vec2 low, Vec2 high, Slot *found) const
    {
        const std::uint32_t left = cellOf((low.x - m_low.x) / m_size.x, m_columns);
        const std::uint32_t right = cellOf((high.x - m_low.x) / m_size.x, m_columns);
        const std::uint32_t top = cellOf((high.y - m_low.y) / m_size.y, m_rows);
        std::size_t count = 0;
        for (std::uint32_t row = cellOf((low.y - m_low.y) / m_size.y, m_rows); row <= top; ++row) {
            for (std::uint32_t column = left; column <= right; ++column)
                count = append(m_heads[indexOf({0, 0, column, row})], found, count);
        }
        return follow(things, found, count);
    }

    /// All that are listed, cell by cell and row by row.
    template <class Thing>
    void all(const Thing *things, Slot *found) const
    {
        for (const Slot head : m_heads) {
            for (Slot slot = head; slot != none; slot = things[slot].link.next)
                *found++ = slot;
        }
    }

private:
    static constexpr Slot none = std::numeric_limits<Slot>::max();
    static constexpr unsigned bit(Wall wall, bool set)
    {
        return static_cast<unsigned>(set) << static_cast<unsigned>(wall);
    }
    static std::uint32_t cellOf(double place, std::uint32_t count);
    /// Empty cells, as many as the reach is wide, surround the grid: none need look for its edge.
    [[nodiscard]] std::size_t indexOf(const CellLink &link) const
    {
        return (std::size_t{link.row} + m_ring) * m_stride + link.column + m_ring;
    }
    template <class Thing>
    void enter(Thing *things, Slot slot)
    {
        CellLink &link = things[slot].link;
        Slot &head = m_heads[indexOf(link)];
        link.previous = none;
        link.next = head;
        if (head != none)
            things[head].link.previous = slot;
        head = slot;
    }
    static double endOf(std::uint32_t cell, bool upper, std::uint32_t cells, double low,
                        double size)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const std::uint32_t cut = cell + (upper ? 1 : 0);
        if (cut == 0)
            return -infinity;
        return cut < cells ? low + static_cast<double>(cut) * size : infinity;
    }
    /// Appends the first of a cell. Without branches: how full it is nobody knows.
    static std::size_t append(Slot slot, Slot *found, std::size_t count)
    {
        found[count] = slot;
        return count + (slot != none ? 1 : 0);
    }
    /// Appends what follows those that are found.
    template <class Thing>
    static std::size_t follow(const Thing *things, Slot *found, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            count = append(things[found[i]].link.next, found, count);
        return count;
    }

    Vec2 m_low{};  ///< the lower left corner, m
    Vec2 m_size{}; ///< of a cell, m
    std::uint32_t m_columns = 1;
    std::uint32_t m_rows = 1;
    std::size_t m_stride = 1;  ///< cells of a row with its ring
    std::uint32_t m_ring = 1;  ///< cells that the reach is wide
    std::vector<Slot> m_heads; ///< the first in each cell, row by row
};

} // namespace cradle
