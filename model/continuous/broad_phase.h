// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/disc_grid.h"
#include "model/continuous/crowd.h"
#include "model/continuous/sort_skin.h"

namespace cradle {

/// A crowd sorted into a grid, so that neighbours are found in few cells. One sort serves many
/// steps: until a circle can have left its cell by more than the skin.
class BroadPhase
{
public:
    void start(const Crowd &crowd);
    /// Whether circles must be sorted before a step of \p dt s.
    [[nodiscard]] bool isStale(double dt) const { return dt != m_dt || isOver(); }
    /// Sorts the circles for steps of \p dt s. \p pairs, which are of slots, are of the new ones
    /// then.
    void sort(double dt, Crowd &crowd, std::span<Crowd::Pair> pairs);
    /// A step was taken.
    void countStep() { ++m_index; }
    /// From now on a circle may have \p speed, m/s.
    void note(double speed) { m_skin.note(speed, m_index); }

    [[nodiscard]] const DiscGrid &grid() const { return m_grid; }
    [[nodiscard]] const SortSkin &skin() const { return m_skin; }
    [[nodiscard]] double dt() const { return m_dt; }            ///< of a step, s
    [[nodiscard]] std::size_t index() const { return m_index; } ///< steps since the sort
    [[nodiscard]] bool isOver() const { return m_index >= m_skin.steps(); }
    /// Until the next sort.
    [[nodiscard]] std::size_t stepsLeft() const { return m_skin.steps() - m_index; }
    [[nodiscard]] double timeLeft() const { return static_cast<double>(stepsLeft()) * m_dt; } ///< s
    [[nodiscard]] double meanSpeed() const { return m_meanSpeed; } ///< at the latest sort, m/s

private:
    DiscGrid m_grid;
    SortSkin m_skin;
    double m_skinWidth = 0.0; ///< that is worth while, m
    double m_dt = 0.0;
    std::size_t m_index = 0;
    double m_meanSpeed = 0.0;
    std::vector<Crowd::Slot> m_moved; ///< working memory of sort(): the new slot of each
};

} // namespace cradle
