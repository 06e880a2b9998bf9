// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/disc_grid.h"
#include "model/world/rules.h"
#include "model/world/world.h"

namespace cradle {

/// The lab's own way: move every circle; where one then reaches into a wall or another circle
/// and they approach, go back to the old position and let the law answer with velocities.
/// Keeps its working memory between steps.
class DiscreteStep
{
public:
    /// Moves \p world on by \p dt s; time and step of \p world are those after the step.
    void run(const Rules &rules, World &world, double dt, std::vector<Hit> &hits);

private:
    void hitWalls(const Rules &rules, World &world, std::vector<Hit> &hits);
    void hitCircles(const Rules &rules, World &world, std::vector<Hit> &hits);
    void hitPair(const Rules &rules, World &world, std::size_t i, std::size_t j,
                 std::vector<Hit> &hits);
    void findNear(const World &world, std::size_t i, double reach);

    std::vector<Vec2> m_old;         ///< positions before the step
    DiscGrid m_grid;                 ///< of the positions after it
    std::vector<std::size_t> m_near; ///< circles after one in the list that may reach into it
};

} // namespace cradle
