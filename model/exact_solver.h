// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/collision_detection.h"
#include "model/contact_solver.h"
#include "model/disc_grid.h"
#include "model/rules.h"
#include "model/world.h"

#include <limits>

namespace cradle {

/// Hard discs in a square under uniform gravity, carried from event to event without a timestep:
/// parabolas between hits, closed-form times of impact, contacts of one moment solved together.
/// Every disc has its own clock and is carried on only when something happens to it.
///
/// Time is cut into epochs. At the start of one the discs are sorted into a grid, and the hits
/// that lie inside it go into a queue. The epoch ends before any disc can have moved farther from
/// its cell than `m_drift`; one that is kicked faster than foreseen shortens it. So a search of the
/// cells within reach cannot miss a partner. Events whose discs have been hit since are skipped.
///
/// The result does not depend on how the time is divided into calls of advance().
/// Theory, and what bounds the number of hits when e < 1: docs/physics.md.
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
    /// Writes places and velocities at the present moment to \p circles.
    void read(std::span<Circle> circles) const;

private:
    using Slot = std::uint32_t;

    /// What the search for events reads of a disc: one line of cache.
    struct alignas(64) Disc {
        Vec2 position{};          ///< at its own clock, m
        Vec2 velocity{};          ///< at its own clock, m/s
        double clock = 0.0;       ///< s into the epoch
        double radius = 0.0;      ///< m
        double inverseMass = 0.0; ///< 1/kg
        std::uint32_t hits = 0;   ///< counts; an event that saw fewer is void
        std::uint32_t held = 0;   ///< bit w: rests on Wall w, which takes the push of gravity
    };
    struct Event {
        double time = 0.0; ///< s into the epoch
        Slot a = 0;
        Slot b = 0; ///< disc, or firstWall + Wall
        std::uint32_t hitsA = 0;
        std::uint32_t hitsB = 0;
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
    static constexpr Slot lookAgain = 0xffffffefU; ///< as a partner: the search went only so far
    static constexpr bool isWall(Slot b) { return b >= firstWall; }
    static constexpr bool isDisc(Slot b) { return b < lookAgain; }
    static constexpr Slot wallSlot(Wall wall) { return firstWall + static_cast<Slot>(wall); }
    static constexpr Wall wallOf(Slot b) { return static_cast<Wall>(b - firstWall); }
    static constexpr std::uint32_t heldBy(Wall wall) { return 1U << static_cast<unsigned>(wall); }
    static bool later(const Event &x, const Event &y) { return x.time > y.time; }
    /// What a push of 1 N s does to a disc, m/s; an exchange of normal parts knows no masses.
    [[nodiscard]] double weight(const Disc &disc) const
    {
        return m_rules.laws.circles == CircleLaw::SwapNormal ? 1.0 : disc.inverseMass;
    }

    // Epochs and the flow of events: exact_solver.cpp
    void setScales();
    void beginEpoch();
    void sortDiscs();
    void limitEpoch(double speed);
    void carryTo(Disc &disc, double time) const;
    [[nodiscard]] bool isVoid(const Event &event) const;
    void takeNext(std::vector<Hit> &hits);
    [[nodiscard]] Vec2 accelerationOf(const Disc &disc) const;

    // The search for events: exact_events.cpp
    void findFirstEvents();
    void findEvents(Slot a);
    void findWallEvent(Slot a);
    template <bool Falling, bool Fresh, class VisitRuns>
    void search(Slot a, VisitRuns visitRuns);
    template <bool Falling>
    void findFirstPairs();
    [[nodiscard]] double travelOf(const Disc &disc) const;
    void findPairEvent(Slot a, Slot b);
    void push(double time, Slot a, Slot b);
    Event pop();

    // How two answer: exact_contacts.cpp
    void hitPair(const Event &event, std::vector<Hit> &hits);
    void hitWall(const Event &event, std::vector<Hit> &hits);
    void respond(Disc &a, Disc &b, Vec2 n, double change, bool lasting) const;
    void noteHit(Slot slot, bool soft);
    void setAgainst(Disc &disc, Wall wall) const;
    [[nodiscard]] Rebound reboundOf(Slot a, Slot b, Vec2 normal, double closing) const;
    [[nodiscard]] double softSpeed(double radius) const;
    [[nodiscard]] bool shakes(Slot slot) const { return m_lossy && m_shaking[slot]; }
    [[nodiscard]] double pressing(Slot a, Slot b, Vec2 normal) const;
    [[nodiscard]] double closingSpeed(Slot a, Slot b, Vec2 normal) const;
    [[nodiscard]] Hit newHit(Slot a, Slot b, Vec2 normal) const;
    static void report(Hit hit, std::vector<Hit> &hits);
    [[nodiscard]] static double kineticLoss(Vec2 before, const Disc &disc);

    // Moments at which more than two meet: exact_moment.cpp
    void takeMoment(const Event &event, std::vector<Hit> &hits);
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
    bool m_lossy = false;       ///< e < 1 or a law that stops: hits may come ever quicker
    std::size_t m_small = 0;    ///< discs in the grid; the few giants follow them
    double m_smallRadius = 0;   ///< the largest in the grid, m
    double m_quiet = 0;         ///< without gravity: slower hits lose nothing, m/s
    double m_lastingSearch = 0; ///< how far ahead a disc in a lasting contact looks, s
    double m_drift = 0;         ///< how far a disc may move in an epoch, m
    double m_nextDrift = 0;     ///< of the next epoch, m
    double m_widestDrift = 0;   ///< the most that is worth while, m
    double m_now = 0;           ///< s into the epoch
    double m_horizon = 0;       ///< until when events are looked for, s into the epoch
    double m_epochEnd = 0;      ///< s into the epoch
    double m_foreseenSpeed = 0; ///< the greatest at m_foreseenAt, m/s
    double m_foreseenAt = 0;    ///< s into the epoch
    double m_foreseenDrift = 0; ///< by then, m
    double m_moment = 0;        ///< events closer than this are one, s
    double m_eventTime = 0;     ///< of the event that is taken, s into the epoch
    double m_startTime = 0;     ///< of the epoch, as hits report it, s
    qint64 m_step = 0;          ///< as hits report it
    DiscGrid m_grid;
    std::vector<Disc> m_discs;        ///< in the order of the grid
    std::vector<std::uint32_t> m_ids; ///< which circle a slot holds
    std::vector<bool> m_shaking;      ///< of each slot, if lossy: the latest hit was soft
    std::vector<Event> m_events;      ///< a heap, the earliest first
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
