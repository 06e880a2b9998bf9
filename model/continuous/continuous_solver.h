// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/disc_grid.h"
#include "model/continuous/continuous_step.h"
#include "model/continuous/pile_step.h"
#include "model/continuous/sleeping_islands.h"
#include "model/continuous/sort_skin.h"
#include "model/continuous/step_groups.h"
#include "model/exact/exact_solver.h"

#include <array>

namespace cradle {

/// Continuous timing for crowds: ContinuousStep for the few circles that meet something in a step,
/// free flight for all others.
///
/// Circles are sorted into a grid every so many steps. Then, and whenever a circle's motion is
/// disturbed, each pair within reach is put down for the first step in which it can meet; only in
/// that step its time of impact is looked for. Nothing is missed (docs/physics.md, 6):
///
///  - Between two disturbances the centres of a pair approach each other in a straight line from
///    step to step, whatever their integrators, so the first step of a meeting is a quadratic;
///    what bends inside a step is added to the reach.
///  - The grid is used only as long as no circle can be farther than the skin (SortSkin) from
///    where it was sorted. A circle that is kicked faster than that allows is noticed, searches
///    its whole way of the step, and the next step sorts anew.
///  - Circles that meet in a step are taken from its start as one group. If a member then leaves
///    its free flight and could reach a circle outside, that joins, and the group starts again.
///
/// A step in which most circles of a crowd would meet several others is divided into parts; so
/// there are no groups of thousands.
///
/// Under gravity, where hits take energy, large groups are piles, which PileStep moves. A pile that
/// has been at rest for a while sleeps, as does what lies still: it stays where it is, and no step
/// looks at it, until something that moves may meet one of it in a step.
///
/// Where every integrator follows the parabola and no hit loses anything, steps that miss no hit
/// and exact timing are the same motion; then ExactSolver does the work, which needs no steps.
class ContinuousSolver
{
public:
    /// Begins with \p circles under \p rules.
    void start(const Rules &rules, std::span<const Circle> circles);
    /// One step of \p dt s. Hits are appended to \p hits; \p time (s) and \p step are those at its
    /// end.
    void advance(double dt, double time, qint64 step, std::vector<Hit> &hits);
    /// Writes places and velocities to \p circles.
    void read(std::span<Circle> circles) const;

private:
    using Slot = StepGroups::Slot;
    using Member = StepGroups::Member;
    static constexpr Slot wall = 0xffffffffU; ///< as a partner: any of the four
    /// Closing speeds below this share of the speeds may be rest; the whole solver sees to them.
    static constexpr double leastClosing = 1e-6;
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Two that may meet, or a circle and a wall.
    struct Candidates {
        Slot a = 0;
        Slot b = 0;
    };
    /// A hit, or two that rest, of the group of a member as of one run.
    struct Found {
        std::uint32_t run = 0;
        std::uint32_t member = 0;
        Hit hit{};
    };
    /// A member, group by group and in the order of the circles.
    struct Place {
        std::uint32_t group = 0;
        std::uint32_t id = 0;
        std::uint32_t member = 0;
        friend auto operator<=>(const Place &, const Place &) = default;
    };
    struct Touching {
        std::uint32_t run = 0;
        std::uint32_t member = 0;
        Candidates pair{};
    };

    // Sorting, and the flow of a step: continuous_solver.cpp
    void startSteps(const Rules &rules, std::span<const Circle> circles);
    void sort(double dt);
    void advancePart(double dt, double time, std::vector<Hit> &hits);
    void findMeanSpeed();
    void flyFreely();
    [[nodiscard]] Motion freely(Slot slot) const;

    // When who can meet: continuous_schedule.cpp
    void scheduleAll();
    void scheduleMembers();
    void scheduleAround(Slot slot);
    template <class Visit>
    void sieve(Slot a, Slot begin, Slot end, double slack, Visit visit) const;
    [[nodiscard]] double slack(bool disturbed) const;
    void schedulePair(Slot a, Slot b, bool disturbed);
    void scheduleWalls(Slot slot);
    void putDown(double time, Slot a, Slot b);
    [[nodiscard]] bool meetInStep(const Candidates &candidates) const;
    [[nodiscard]] Path pathOf(Slot slot) const;

    // Groups: continuous_groups.cpp
    void findGroups();
    void solveGroups(std::vector<Hit> &hits);
    [[nodiscard]] bool isPile(std::size_t members) const;
    [[nodiscard]] std::span<const Place> groupFrom(std::size_t begin) const;
    void foreseePiles();
    void solve(std::span<const Place> places);
    bool solvePair(std::uint32_t member, std::uint32_t other, std::uint32_t run);
    void widen(std::uint32_t index);
    void join(Slot a, Slot b);
    std::uint32_t activate(Slot slot);

    // What sleeps: continuous_sleep.cpp
    [[nodiscard]] bool sleeps(Slot slot) const { return m_sleep.sleeps(m_ids[slot]); }
    void layToSleep();
    void wake(Slot slot);
    void scheduleSleeper(Slot a, Slot b);
    [[nodiscard]] double fastestOf(Slot slot) const;
    [[nodiscard]] double massOf(Slot slot) const;
    [[nodiscard]] bool reachesWall(Slot slot, double speed) const;

    ExactSolver m_exact;
    bool m_isExact = false; ///< m_exact does the work

    Rules m_rules{};
    bool m_alike = true;  ///< one integrator for all
    double m_gravity = 0; ///< its size, m/s²
    bool m_piles = false; ///< large groups come to rest as one
    double m_dt = 0;      ///< of the steps that are put down, s
    double m_time = 0;    ///< at the end of the step, s
    qint64 m_stepNumber = 0;
    double m_freePath = 0;  ///< mean, m
    double m_meanSpeed = 0; ///< at the latest sort, m/s
    double m_skinWidth = 0; ///< that is worth while, m
    SortSkin m_skin;
    std::size_t m_index = 0;  ///< steps since the sort
    std::size_t m_small = 0;  ///< circles in the grid; the few giants follow them
    double m_smallRadius = 0; ///< the largest in the grid, m
    DiscGrid m_grid;

    // By slot, in the order of the grid.
    std::vector<Motion> m_motions;
    std::vector<double> m_radii;
    std::vector<std::uint32_t> m_ids;    ///< which circle a slot holds
    std::vector<Motion> m_sortedMotions; ///< while sorting
    std::vector<double> m_sortedRadii;
    std::vector<std::uint32_t> m_sortedIds;

    // By circle.
    std::vector<double> m_densities;
    std::vector<Integrator> m_integrators;
    SleepingIslands m_sleep;
    std::vector<Slot> m_slotOf; ///< if any sleep

    std::array<std::vector<Candidates>, SortSkin::mostSteps>
        m_due;                         ///< who may first meet in each step
    std::vector<Candidates> m_resting; ///< stay in touch from step to step
    StepGroups m_groups;               ///< of this step
    double m_kicked = 0;               ///< the fastest of them, m/s
    std::vector<Candidates> m_inVain;  ///< did not meet after all
    std::vector<Place> m_order;
    std::vector<std::pair<double, std::uint32_t>> m_sequence; ///< of the hits found, by time
    std::vector<Found> m_found;
    std::vector<Touching> m_touching;
    std::uint32_t m_runs = 0;
    std::vector<Hit> m_hits; ///< of a group
    ContinuousStep m_step;
    PileStep m_pile;
    World m_world;                       ///< a group
    std::vector<std::uint32_t> m_people; ///< its circles
    Rules m_groupRules;
};

} // namespace cradle
