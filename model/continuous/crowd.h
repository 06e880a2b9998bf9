// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/collision_detection.h"
#include "model/continuous/sleeping_islands.h"
#include "model/world/rules.h"

#include <cmath>

namespace cradle {

/// A step of a crowd, or a part of one.
struct TimeStep {
    double dt = 0.0;  ///< s
    double end = 0.0; ///< when it ends, s
    qint64 number = 0;
};

/// The circles of a crowd and the rules that they follow. A circle stands in a slot; BroadPhase
/// says in which. The few giants (GiantsApart) stand behind all others.
struct Crowd {
    using Slot = std::uint32_t;

    /// Two that may meet, or a circle and a wall.
    struct Pair {
        Slot a = 0;
        Slot b = 0; ///< or \c wall
    };
    static constexpr Slot wall = 0xffffffffU; ///< as a partner: any of the four

    void start(const Rules &ruled, std::span<const Circle> circles);
    /// Writes places and velocities to \p circles.
    void read(std::span<Circle> circles) const;
    /// Stands those that are no giants in the order of \p sorted, slots as they were.
    void arrange(std::span<const Slot> sorted);

    [[nodiscard]] Slot count() const { return static_cast<Slot>(motions.size()); }
    /// Who sleeps stays where it is.
    [[nodiscard]] bool sleeps(Slot slot) const { return sleep.sleeps(ids[slot]); }
    [[nodiscard]] Integrator integrator(Slot slot) const { return rules.integrators[ids[slot]]; }
    [[nodiscard]] Circle circle(Slot slot) const
    {
        return {motions[slot].position, motions[slot].velocity, radii[slot], densities[ids[slot]]};
    }
    [[nodiscard]] double speed(Slot slot) const ///< m/s
    {
        return std::sqrt(lengthSquared(motions[slot].velocity));
    }
    [[nodiscard]] Path path(Slot slot) const;
    /// How a circle moves in \p dt s if it meets nothing.
    [[nodiscard]] Motion freely(Slot slot, double dt) const;
    /// Moves all of them so.
    void flyFreely(double dt);
    /// Whether groups of so many circles are piles: under gravity, where hits take energy, moment
    /// by moment a heap of 25 takes a hundred times as long, and its overlaps grow to a twentieth
    /// of a radius.
    [[nodiscard]] bool isPile(std::size_t circles) const
    {
        constexpr std::size_t largestGroup = 8;
        return hasPiles && circles > largestGroup;
    }

    Rules rules{};
    double gravity = 0.0;     ///< its size, m/s²
    bool alike = true;        ///< one integrator for all
    bool hasPiles = false;    ///< large groups come to rest as one
    double width = 0.0;       ///< of the square, or else of the crowd at its start, m
    double freePath = 0.0;    ///< mean, m
    Slot small = 0;           ///< so many are no giants
    double smallRadius = 0.0; ///< the largest of those, m

    // By slot.
    std::vector<Motion> motions;
    std::vector<double> radii;
    std::vector<std::uint32_t> ids; ///< which circle a slot holds

    // By circle.
    std::vector<double> densities;
    SleepingIslands sleep;
    std::vector<Slot> slotOf; ///< of those that sleep

private:
    // Working memory of arrange().
    std::vector<Motion> m_motions;
    std::vector<double> m_radii;
    std::vector<std::uint32_t> m_ids;
};

} // namespace cradle
