// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/collision_detection.h"
#include "model/contacts/contact_solver.h"
#include "model/continuous/continuous_neighbours.h"
#include "model/world/rules.h"
#include "model/world/world.h"

namespace cradle {

/// A step that finds every time of impact inside it and spends the rest of the step after it.
/// Each circle has its own clock and is split only at its own hits. Contacts at the same moment
/// are resolved together. From its first hit in a step on a circle follows its parabola. A circle
/// whose rebound would last less than a step (2 e u / a < Δt) comes to rest; what rests is held by
/// contact forces until something moves it.
///
/// Where e < 1, circles that lie on each other end the step at velocities v' that no longer close
/// faster than their gaps allow,
///     v' = v + a h + Σ J n / m,   0 ≤ J ⊥ gap/h − (closing speed of v') ≥ 0,
/// and move there evenly, h being what is left of the step: then they cannot overlap, for discs
/// are convex, and take −½ m |v' − v|² − Σ J gap/h of energy, which is never a gain.
/// Source: Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988.
///
/// Keeps its working memory between steps.
class ContinuousStep
{
public:
    /// Moves \p world on by \p dt s; time and step of \p world are those after the step.
    void run(const Rules &rules, World &world, double dt, std::vector<Hit> &hits);

    /// Pairs that lay on each other in the latest step and may still do.
    [[nodiscard]] const std::vector<std::pair<int, int>> &restingPairs() const
    {
        return m_rest.pairs;
    }

private:
    /// Of the radius: a deeper overlap is none that this timing leaves, and is parted. One that a
    /// pile has left stays as it is, for to part two takes energy that nobody has.
    static constexpr double deepOverlap = 1e-3;

    struct Body {
        double since = 0.0;  ///< s into the step: how far this circle has come
        Vec2 acceleration{}; ///< gravity less what holds it, m/s²
        Vec2 drift{};        ///< m/s; where it drifts: how its place moves until the step ends
        Vec2 latestHit{};    ///< where, m
        std::uint32_t version = 0;                  ///< events found under another are void
        int nearHits = 0;                           ///< lossy ones in a row at the same place
        Integrator integrator = Integrator::Verlet; ///< its own until it is hit or rests
        bool drifts = false;                        ///< is held among others
        bool touched = false;                       ///< its events must be found again
    };
    struct Event {
        double time = 0.0; ///< s into the step
        int a = 0;
        int b = 0; ///< circle, or Wall as an int
        bool wall = false;
        std::uint32_t versionA = 0;
        std::uint32_t versionB = 0;
    };
    /// What meets at one moment.
    struct Moment {
        std::vector<Event> events;
        std::vector<Contact> contacts; ///< of these, and what holds who comes to rest
        std::vector<Hit> hits;         ///< one per event
        std::vector<Vec2> changes;     ///< of the velocities, m/s; zero between uses
    };
    /// What rests, and how it is held.
    struct Rest {
        std::vector<std::pair<int, int>> pairs; ///< that lie on each other, in order
        std::vector<std::pair<int, int>> held;  ///< those that drift and cannot meet, in order
        std::vector<Contact> contacts;          ///< that hold who was touched
        std::vector<char> marks;                ///< of bodies: seen, or in a contact with another
    };

    /// Whether circles rebound slower than they meet.
    [[nodiscard]] bool isLossy() const
    {
        return m_rules->laws.circles == CircleLaw::Impulse && m_rules->restitution < 1.0;
    }
    [[nodiscard]] static std::size_t at(int index) { return static_cast<std::size_t>(index); }

    // Motion and events: continuous_step.cpp
    void begin();
    void foreseeSpeeds();
    void touch(std::size_t body);
    void touchAll();
    void findEvents();
    void findWallEvents(std::size_t i);
    void findPairEvent(std::size_t i, std::size_t j);
    void push(const Event &event);
    [[nodiscard]] bool isValid(const Event &event) const;
    [[nodiscard]] bool nextMoment();
    void takeEventsAt(double time);
    void touchRestingNeighbours();
    void carryTo(std::size_t body, double time);
    [[nodiscard]] Path pathFrom(std::size_t body, double time) const;

    // What rests, and the forces that hold it: continuous_rest.cpp
    void findRestingPairs();
    void rest(std::pair<int, int> pair);
    void findAccelerations();
    void findPiles();
    void addPairs();
    void addWalls();
    void hold();
    void spreadDrift();
    [[nodiscard]] double gapOf(const Contact &contact) const;
    [[nodiscard]] double freeSpeed(const Contact &contact) const;
    [[nodiscard]] bool staysClose(const Contact &contact) const;
    [[nodiscard]] bool isHeld(std::size_t body, Vec2 wall) const;
    [[nodiscard]] Contact contactOf(std::pair<int, int> pair) const;
    [[nodiscard]] double closingSpeed(const Contact &contact) const;
    [[nodiscard]] double closingAcceleration(const Contact &contact) const;

    // How the contacts of one moment answer: continuous_contacts.cpp
    void resolve(std::vector<Hit> &hits);
    void meet(const Event &event);
    void addSupports();
    void respondTogether();
    void respondInTurn();
    [[nodiscard]] double restitutionOf(const Contact &contact) const;
    [[nodiscard]] bool comesToRest(const Contact &contact, double closing) const;
    [[nodiscard]] bool isCollapse(const Contact &contact);

    const Rules *m_rules = nullptr; ///< of the step that runs
    World *m_world = nullptr;
    double m_dt = 0.0;
    double m_now = 0.0;  ///< s into the step
    double m_slow = 0.0; ///< m/s; closing speeds up to this are rest
    ContinuousNeighbours m_neighbours;
    std::vector<Body> m_bodies;
    std::vector<double> m_inverseMasses;
    std::vector<std::size_t> m_touched; ///< bodies, in order once a moment is taken
    std::vector<Event> m_events;        ///< that lie inside the step, a heap, the earliest first
    Moment m_moment;                    ///< the latest
    Rest m_rest;
};

} // namespace cradle
