// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/disc_grid.h"
#include "model/continuous/pile_contacts.h"
#include "model/world/rules.h"
#include "model/world/world.h"

#include <unordered_map>

namespace cradle {

/// A step of a large pile under gravity, whose circles rebound slower than they meet: all its
/// contacts at once, for moment by moment each of them would cost as much as all.
///
///  1. Motion. Velocities w = v + g h + Σ J n / m, at which no contact closes faster than its gap
///     allows, 0 ≤ J ⊥ gap/h − (closing speed of w) ≥ 0. Pushed circles move evenly at w and so
///     cannot overlap, for discs are convex. That takes ½ m |w − v|² + Σ J gap/h of energy.
///  2. Rebound. Where contacts were met faster than gravity alone brings them together, the same
///     with −e times the speed at which they were met in place of gap/h gives the velocities
///     after the step; if their energy were more than there was, they are taken only that far.
///  3. Circles that nothing pushes fly on as their integrators have it.
///
/// A hit has the time at which the two would have met. Pushes are found to a share of a radius in
/// a step, from those of the step before; circles come to rest that much apart from each other.
/// Source: Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988.
class PileStep
{
public:
    /// Forgets the pushes of earlier steps.
    void clear() { m_pushes.clear(); }

    /// Moves \p world on by \p dt s; its time and step are those after the step. \p ids are the
    /// circles' names, by which their pushes are known in the next step. \p rules has their
    /// integrators.
    void run(const Rules &rules, World &world, std::span<const std::uint32_t> ids, double dt,
             std::vector<Hit> &hits);

    /// Pairs that pushed each other in the latest step.
    [[nodiscard]] const std::vector<std::pair<int, int>> &pushingPairs() const { return m_pairs; }

private:
    using Body = std::uint32_t;
    /// Two bodies so near that they may meet in the step.
    struct Near {
        Body a = 0;
        Body b = 0;         ///< or a wall
        double met = -1.0;  ///< when they would meet, s into the step; none if negative
        Vec2 normal{};      ///< from a to b, when they would meet or else at the start
        double gap = 0.0;   ///< along it at the start, m
        double speed = 0.0; ///< at which they meet, m/s
        bool active = false;
    };

    [[nodiscard]] bool isWall(Body body) const { return body >= m_circles.size(); }
    [[nodiscard]] Vec2 outwards(Body wall) const
    {
        return outwardNormal(static_cast<Wall>(wall - m_circles.size()));
    }
    // The motion: pile_step.cpp
    void begin(std::span<const std::uint32_t> ids);
    void findMotion();
    void setFree();
    void activateFirst(bool again);
    void activate(Near &near);
    [[nodiscard]] bool activateMissed();
    [[nodiscard]] double limitOf(double gap) const;
    void fly();
    void keepPushes();

    // Who may meet: pile_near.cpp
    void findNear();
    void addNear(Body a, Body b);
    void lookAt(Near &near) const;
    [[nodiscard]] bool haveComeFar();
    [[nodiscard]] bool isSlow(const Near &near) const;
    [[nodiscard]] double gapOf(const Near &near, const std::vector<Vec2> &places) const;
    [[nodiscard]] std::uint64_t keyOf(const Near &near) const;

    // The end of the step: pile_rebound.cpp
    void partEnds();
    bool part(const Near &near);
    void rebound();
    void boundEnergy();
    [[nodiscard]] double gained(std::span<const Vec2> velocities) const;
    void report(std::vector<Hit> &hits) const;

    const Rules *m_rules = nullptr; ///< of the step that runs
    World *m_world = nullptr;
    double m_dt = 0.0;
    double m_gain = 0.0;      ///< m/s that gravity gives in the step
    double m_tolerance = 0.0; ///< an error of a closing speed that is as good as none, m/s
    double m_borne = 0.0;     ///< an overlap that is, m
    double m_apart = 0.0;     ///< what may be left between two that touch, m
    DiscGrid m_grid;

    // In the order of height.
    std::vector<std::uint32_t> m_order; ///< where a body is in the world
    std::vector<std::uint32_t> m_ids;
    std::vector<Circle> m_circles; ///< at the start
    std::vector<double> m_ways;    ///< how far each may come in the step, m
    std::vector<Vec2> m_ends;      ///< places at the end, m
    std::vector<Vec2> m_unparted;  ///< the same before overlaps were taken away
    std::vector<Vec2> m_motion;    ///< w, m/s
    std::vector<char> m_pushed;    ///< moves evenly
    PileBodies m_bodies;

    std::vector<Near> m_near;
    std::vector<PileContact> m_contacts;
    std::vector<std::uint32_t> m_nearOf; ///< of each contact
    std::vector<PileContact> m_rebounds;
    std::vector<std::uint32_t> m_contactOf; ///< of each of them
    std::vector<double> m_impulses;         ///< of each contact, in the end, N s
    std::vector<std::pair<int, int>> m_pairs;
    std::unordered_map<std::uint64_t, double> m_pushes; ///< of the latest step, by pair, N s
};

} // namespace cradle
