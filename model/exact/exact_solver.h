// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/collision_detection.h"
#include "model/contacts/contact_solver.h"
#include "model/exact/cell_lists.h"
#include "model/exact/tournament.h"
#include "model/world/rules.h"
#include "model/world/world.h"

#include <cmath>
#include <limits>

namespace cradle {

/// Hard discs in a square under uniform gravity, carried from event to event without a timestep:
/// parabolas between hits, closed-form times of impact, contacts of one moment solved together.
/// Every disc has its own clock and is carried on only when something happens to it.
///
/// Discs are listed in cells as wide as two of them. A disc that was hit looks for its next hit
/// among those of the cells around, one that comes into the next cell among those that this brings
/// near; so it cannot miss a partner. Each has its next event in a queue. If the partner has been
/// hit since, it looks again.
///
/// When two meet follows from where each was hit last, whenever that is worked out. So cells and
/// searches leave no trace in the result, nor does how the time is divided into calls of advance().
/// Theory, and what bounds the number of hits when e < 1: docs/physics.md. Where they still come
/// by the ten thousand a frame the solver stops: the crowd hasCollapsed().
/// Source of the method: Rapaport, The Art of Molecular Dynamics Simulation, 2nd ed., ch. 14;
/// of the own clocks and the queue: Lubachevsky, J. Comput. Phys. 94 (1991) 255.
class ExactSolver
{
public:
    /// Begins with \p circles under \p rules.
    void start(const Rules &rules, std::span<const Circle> circles);
    /// Goes on by \p dt s. Hits are appended to \p hits; \p time (s) and \p step are those at the
    /// end of the advance, as hits report them.
    void advance(double dt, double time, qint64 step, std::vector<Hit> &hits);
    /// The same in parts: sets where to go, and what is to be reported,
    void aim(double dt, double time, qint64 step);
    /// and goes there, but through no more than \p events events. Hits are appended to \p hits.
    /// \return whether it is there, or has collapsed; else it goes on when called again
    [[nodiscard]] bool run(std::size_t events, std::vector<Hit> &hits);
    /// Whether hits that nobody sees, of circles that lie on each other, have come to outnumber
    /// what can be followed. The present moment is then that of the latest one, and stays so.
    [[nodiscard]] bool hasCollapsed() const { return m_collapsed; }
    /// What is left of the way to where it was to go; 0 unless it has collapsed, s.
    [[nodiscard]] double left() const { return m_left; }
    /// Writes places and velocities at the present moment to \p circles.
    void read(std::span<Circle> circles) const;

private:
    using Slot = std::uint32_t;
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    /// Closing speeds below this share of the speeds concerned are rounding.
    static constexpr double roundedSpeed = 1e-13;

    /// What comes next for a disc, s into the epoch.
    struct Plan {
        double hit = infinity;   ///< the first that it has found
        double then = infinity;  ///< the one after that, if it has found more
        double leave = infinity; ///< when it comes into the next cell
        Slot partner = 0;        ///< of the hit: a disc, or firstWall + Wall
        std::uint32_t partnerHits = 0;
        Wall side = Wall::Left; ///< to which it leaves its cell
    };
    /// A disc; what a search reads of others comes first and is one line of cache.
    struct alignas(64) Disc {
        Vec2 position{};          ///< at its own clock, m
        Vec2 velocity{};          ///< at its own clock, m/s
        double clock = 0.0;       ///< s into the epoch
        double radius = 0.0;      ///< m
        std::uint32_t hits = 0;   ///< counts; a plan that saw fewer is void
        std::uint32_t held = 0;   ///< bit w: rests on Wall w, which takes the push of gravity
        CellLink link{};          ///< of the cell in which it is listed
        double inverseMass = 0.0; ///< 1/kg
        Plan plan{};
    };
    /// How two answer.
    struct Rebound {
        double speed = 0.0;   ///< at which they part, m/s
        bool soft = false;    ///< too slow to lose anything
        bool lasting = false; ///< a contact that goes on, not a hit to tell of
    };
    /// Two that are in touch at this moment.
    struct Meeting {
        Slot a = 0;
        Slot b = 0; ///< disc, or firstWall + Wall
        friend bool operator==(const Meeting &, const Meeting &) = default;
    };
    static constexpr Slot firstWall = 0xfffffff0U;
    static constexpr bool isWall(Slot b) { return b >= firstWall; }
    static constexpr Slot wallSlot(Wall wall) { return firstWall + static_cast<Slot>(wall); }
    static constexpr Wall wallOf(Slot b) { return static_cast<Wall>(b - firstWall); }
    static constexpr std::uint32_t heldBy(Wall wall) { return 1U << static_cast<unsigned>(wall); }
    /// What a push of 1 N s does to a disc, m/s; an exchange of normal parts knows no masses.
    [[nodiscard]] double weight(const Disc &disc) const
    {
        return m_rules.laws.circles == CircleLaw::SwapNormal ? 1.0 : disc.inverseMass;
    }

    [[nodiscard]] Vec2 accelerationOf(const Disc &disc) const
    {
        return disc.held == 0 ? m_rules.gravity : accelerationHeld(disc);
    }
    [[nodiscard]] Vec2 accelerationHeld(const Disc &disc) const;
    void carryTo(Disc &disc, double time) const
    {
        const double s = time - disc.clock;
        const Vec2 a = accelerationOf(disc);
        disc.position += s * (disc.velocity + (0.5 * s) * a);
        disc.velocity += s * a;
        disc.clock = time;
    }

    // Epochs and the flow of events: exact_solver.cpp
    void setScales();
    void beginEpoch();
    void sortDiscs();
    void listDiscs();
    [[nodiscard]] bool isVoid(const Plan &plan) const;
    void takeNext(std::vector<Hit> &hits);
    void takeHit(Slot a, std::vector<Hit> &hits);

    // The search for events: exact_events.cpp
    void findFirstEvents();
    void findEvents(Slot a);
    void findEventsFrom(Slot a, Slot from);
    void cross(Slot a);
    template <bool Falling>
    void complete(Slot a, Plan &plan, std::size_t count, Slot from);
    template <bool Falling>
    void planLeaving(Slot a, Plan &plan) const;
    void note(Plan &plan, Slot b, double time) const;
    void noteHitOfUnlike(Plan &plan, Slot a, Slot b) const;
    void noteWallHit(Plan &plan, Slot a, Wall wall) const;
    [[nodiscard]] std::size_t listNear(Slot a);
    [[nodiscard]] std::size_t listGiants(std::size_t count);

    // How two answer: exact_contacts.cpp
    void hitPair(Slot slotA, Slot slotB, std::vector<Hit> &hits);
    void hitWall(Slot a, Wall wall, std::vector<Hit> &hits);
    void respond(Disc &a, Disc &b, Vec2 n, double change, bool lasting) const;
    void noteHit(Slot slot, bool soft);
    void noteLasting();
    void setAgainst(Disc &disc, Wall wall) const;
    [[nodiscard]] Rebound reboundOf(Slot a, Slot b, Vec2 normal, double closing) const;
    [[nodiscard]] double softSpeed(double radius, bool shaking) const;
    /// Of what rises by \p height (m), m/s.
    [[nodiscard]] double riseSpeed(double height) const
    {
        return std::sqrt(2.0 * m_gravity * height);
    }
    [[nodiscard]] bool shakes(Slot slot) const { return m_lossy && m_shaking[slot]; }
    [[nodiscard]] bool arePressed(Slot a, Slot b, Vec2 normal) const;
    [[nodiscard]] double closingSpeed(Slot a, Slot b, Vec2 normal) const;
    [[nodiscard]] Hit newHit(Slot a, Slot b, Vec2 normal) const;
    static void report(Hit hit, std::vector<Hit> &hits);
    [[nodiscard]] static double kineticLoss(Vec2 before, const Disc &disc);

    // Moments at which more than two meet: exact_moment.cpp
    void takeMoment(Slot a, Slot b, std::vector<Hit> &hits);
    void meet(Slot a, Slot b);
    std::uint32_t touch(Slot slot);
    void joinNeighbours(Slot slot);
    void answerTogether(std::vector<Hit> &hits);
    void answerInTurn(std::vector<Hit> &hits);
    void settleOnWalls();
    static void release(Disc &disc);
    [[nodiscard]] Vec2 normalOf(const Meeting &m) const;

    Rules m_rules{};        ///< but for the integrators
    double m_gravity = 0.0; ///< its size, m/s²
    bool m_walls = false;
    bool m_pairs = false;
    bool m_lossy = false;      ///< e < 1 or a law that stops: hits may come ever quicker
    std::size_t m_small = 0;   ///< discs in cells; the few giants follow them
    double m_smallRadius = 0;  ///< the largest in cells, m
    double m_rows = 1;         ///< of a heap as wide as high of all discs, as if they were alike
    double m_quiet = 0;        ///< without gravity: slower hits lose nothing, m/s
    double m_now = 0;          ///< s into the epoch
    double m_moment = 0;       ///< events closer than this are one, s
    double m_eventTime = 0;    ///< of the event that is taken, s into the epoch
    double m_startTime = 0;    ///< of the epoch, as hits report it, s
    qint64 m_step = 0;         ///< as hits report it
    double m_elapsed = 0;      ///< at the begin of the epoch, since the start, s
    double m_windowEnd = 0;    ///< since the start, s; until then lasting contacts are counted
    std::size_t m_lasting = 0; ///< so many
    bool m_collapsed = false;
    double m_left = 0;           ///< when it collapsed: to where it should have gone, s
    std::size_t m_hits = 0;      ///< of discs, in this epoch
    std::size_t m_crossings = 0; ///< of cells, since discs were listed
    CellLists m_cells;
    Tournament m_queue;
    std::vector<Disc> m_discs;        ///< in the order of the cells
    std::vector<std::uint32_t> m_ids; ///< which circle a slot holds
    std::vector<bool> m_shaking;      ///< of each slot, if lossy: the latest hit was soft
    std::vector<Slot> m_near;         ///< for a search
    std::vector<bool> m_moved;        ///< while sorting
    // Of this moment; bodies of contacts are places in m_touched.
    std::vector<Slot> m_touched;
    std::vector<std::uint32_t> m_place; ///< of each slot in m_touched, where it is there
    std::vector<Meeting> m_meetings;
    std::vector<Contact> m_contacts;
    bool m_soft = false; ///< no hit of it was fast enough to lose anything
    std::vector<double> m_weights;
    std::vector<Vec2> m_changes; ///< of the velocities, m/s
};

} // namespace cradle
