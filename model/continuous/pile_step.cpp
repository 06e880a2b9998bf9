// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_step.h"

#include "model/continuous/pile_ends.h"
#include "model/continuous/pile_rebound.h"

namespace cradle {

void PileStep::run(const Rules &rules, World &world, std::span<const std::uint32_t> ids, double dt,
                   std::vector<Hit> &hits)
{
    // Sort the circles by height.
    const Pile pile(rules, world.circles, ids, dt);
    // Motion: who may meet, and the pushes at which no contact closes faster than its gap allows.
    findMotion(pile, m_pushes, m_motion);
    const PileMotion &motion = m_motion;
    // Move the circles, and part what still overlaps.
    PileEnds ends = fly(pile, motion);
    partOverlaps(pile, motion, ends);
    // Rebound: the velocities at which what was met parts, as far as there is energy for it.
    const PileRebound rebound = findRebound(pile, motion, ends);
    // Tell of the hits, and begin with these pushes in the next step.
    reportHits(pile, motion, rebound, world, hits);
    m_pushes.keep(pile, motion.contacts, motion.near, motion.nearOf);
    m_pairs.clear();
    for (const PileContact &c : motion.contacts) {
        if (c.push > 0.0 && !pile.isWall(c.b))
            m_pairs.emplace_back(static_cast<int>(pile.order[c.a]),
                                 static_cast<int>(pile.order[c.b]));
    }
    for (Pile::Body i = 0; i < pile.count(); ++i) {
        Circle &c = world.circles[pile.order[i]];
        c.position = ends.places[i];
        c.velocity = rebound.velocities[i];
    }
}

} // namespace cradle
