// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/collision_detection.h"
#include "model/contact_solver.h"
#include "model/disc_grid.h"
#include "model/rules.h"
#include "model/world.h"

namespace cradle {

/// A step that finds every time of impact inside it and spends the rest of the step after it.
/// Each circle has its own clock and is split only at its own hits. Contacts at the same moment
/// are resolved together. From its first hit in a step on a circle follows its parabola. A circle
/// whose rebound would last less than a step (2 e u / a < Δt) comes to rest; what rests is held by
/// contact forces until something moves it. Keeps its working memory between steps.
class ContinuousStep
{
public:
    /// Moves \p world on by \p dt s; time and step of \p world are those after the step.
    void run(const Rules &rules, World &world, double dt, std::vector<Hit> &hits);

    /// Pairs that were in touch in the latest step and may still be.
    [[nodiscard]] const std::vector<std::pair<int, int>> &restingPairs() const { return m_resting; }

private:
    struct Body {
        double since = 0.0;  ///< s into the step: how far this circle has come
        Vec2 acceleration{}; ///< gravity less what holds it, m/s²
        Integrator integrator = Integrator::Verlet; ///< its own until it is hit or rests
        bool touched = false;                       ///< its events must be found again
    };
    struct Event {
        double time = 0.0; ///< s into the step
        int a = 0;
        int b = 0; ///< circle, or Wall as an int
        bool wall = false;
        friend bool operator==(const Event &, const Event &) = default;
    };

    // Motion and events: continuous_step.cpp
    void begin();
    void findNeighbours(double fastest);
    [[nodiscard]] std::span<const std::uint32_t> neighboursOf(std::size_t body) const;
    void foreseeSpeeds();
    void touch(std::size_t body);
    void findEvents();
    void findPairEvent(std::size_t i, std::size_t j);
    void takeEventsAt(double time);
    void touchRestingNeighbours();
    void carryTo(std::size_t body, double time);
    [[nodiscard]] Path pathFrom(std::size_t body, double time) const;

    // What rests, and the forces that hold it: continuous_rest.cpp
    void findRestingPairs();
    void rest(std::pair<int, int> pair);
    void findAccelerations();
    [[nodiscard]] bool isHeld(std::size_t body, Wall wall) const;
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

    const Rules *m_rules = nullptr; ///< of the step that runs
    World *m_world = nullptr;
    double m_dt = 0.0;
    double m_now = 0.0;           ///< s into the step
    double m_slow = 0.0;          ///< m/s; closing speeds up to this are rest
    bool m_plastic = false;       ///< too many hits in one step: no more rebounds
    double m_foreseenSpeed = 0.0; ///< m/s; for up to this the neighbours are all
    std::vector<Body> m_bodies;
    std::vector<Vec2> m_places;                  ///< at the start of the step, m
    DiscGrid m_grid;                             ///< of the places
    std::vector<std::uint32_t> m_firstNeighbour; ///< of each body in m_neighbours, and the end
    std::vector<std::uint32_t> m_neighbours;
    std::vector<double> m_inverseMasses;
    std::vector<std::size_t> m_touched; ///< bodies, in order once a moment is taken
    std::vector<Event> m_events;        ///< all that lie inside the step, in no order
    std::vector<Event> m_taken;         ///< those of this moment
    std::vector<Contact> m_contacts;
    std::vector<Hit> m_hits;                    ///< one per contact of this moment
    std::vector<Vec2> m_changes;                ///< of the velocities, m/s
    std::vector<std::pair<int, int>> m_resting; ///< pairs that stay in touch
};

} // namespace cradle
