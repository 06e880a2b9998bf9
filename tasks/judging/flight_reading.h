// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/ground.h"
#include "tasks/judging/probe.h"

#include <array>
#include <optional>

namespace cradle {

/// How a program moves one circle freely, under one gravity and with one timestep h:
///
///     x' = x + way ∘ v h + drift        v' = v + growth ∘ v h + acceleration h
///
/// with ∘ for the product part by part. Measured from the second step of a few short flights, so
/// that what a program keeps from one step to the next has settled.
struct Flight {
    /// One step of a flight, as it was seen.
    struct Step {
        Vec2 velocity{}; ///< before it, m/s
        Vec2 way{};      ///< m
        Vec2 turn{};     ///< change of the velocity, m/s
    };
    /// A part of the velocity that moves the other part of the place.
    enum class Crossing { None, XMovesY, YMovesX, Exchanged };
    /// What a part of the place after a step follows: itself before it, the other part, or nothing,
    /// so that it is the same wherever the circle started; Unclear where it is none of these.
    enum class Follows { Itself, Other, Nothing, Unclear };

    Vec2 way{1.0, 1.0};   ///< share of v h that the position changes by; 1 is right
    Vec2 drift{};         ///< m in a step, what the acceleration adds
    Vec2 acceleration{};  ///< m/s², of a circle at rest
    Vec2 growth{};        ///< 1/s; negative where something brakes
    Vec2 pull{};          ///< 1/s², what the place changes the acceleration by
    bool isKnown = false; ///< it follows such a law
    bool resets = false;  ///< the velocity after a step does not depend on that before
    bool resetsX = false; ///< the same of one part of the velocity alone
    bool resetsY = false;
    /// What it is after the first step it is only there: later steps go on from that.
    bool keepsOwnVelocity = false;
    double carried = 1.0;       ///< share of the old place that is in the new one; 1 is right
    bool jumps = false;         ///< the place after a step does not depend on that before
    bool keepsOwnPlace = false; ///< but later steps go on from where the first one ends
    Follows xFollows = Follows::Itself; ///< how the first step goes on from the x of the start
    Follows yFollows = Follows::Itself;
    Vec2 startedAt{};          ///< for words about it, m
    Vec2 putAt{};              ///< where it was one step later, m
    bool isOfStart = false;    ///< each step goes on from where the run began
    int leader = -1;           ///< the circle whose velocity moves it, if it is not its own
    bool isFromLeader = false; ///< it goes on from where that one is
    int borrows = -1;          ///< the circle whose velocity it has after a step, and not its own
    bool onlySlow = false;     ///< what resets does so of slow circles only
    /// Where another stands, m, so that what resets it elsewhere leaves it its velocity.
    std::optional<Vec2> freedBy{};
    bool isTimeless = true; ///< the same start gives the same step at any time of a run
    bool isCounted = false; ///< it does so again a step or two later than where it does not
    Vec2 lateWay{};         ///< of a step late in a run that starts as seen[0] did, m
    Vec2 lateVelocity{};    ///< after the first of such steps, m/s
    Vec2 firstWay{};        ///< of the first step of a run, m
    Vec2 lateFirstWay{};    ///< and of the first of the late ones, m
    /// Which flights show something: any, or only those that are fast, or slow.
    enum class Speed { Any, Fast, Slow };
    /// A flight whose first step changes its velocity otherwise than later ones do.
    struct Leap {
        Vec2 from{}; ///< velocity, m/s
        Vec2 to{};   ///< m/s
        Speed speed = Speed::Any;
    };
    std::optional<Leap> leap{};
    bool isWayOfNew = false;  ///< the way is that of the velocity at the end of the step
    int follows = -1;         ///< the circle at whose place it is after a step, wherever it started
    bool isWayLinear = true;  ///< no flight contradicts that its way is such a share
    bool isTurnLinear = true; ///< nor the change of its velocity
    Crossing crossing = Crossing::None;
    std::array<Step, 2> seen{}; ///< of two flights
    Step fromRest{};            ///< of one that started at rest
    Vec2 restedAt{};            ///< where that was, m
    Vec2 startedWith{};         ///< velocity, for words about it, m/s
    Vec2 turnedInto{};          ///< what became of that in the first step, m/s
    Vec2 wayMade{};             ///< and how far it went in the second, m

    /// The state one step after \p c, if nothing is hit.
    [[nodiscard]] Motion after(const Circle &c, double h) const;
    /// c in the drift c a h², if there is an acceleration that shows it.
    [[nodiscard]] std::optional<double> share(double h) const;
};

/// The flights of all circles of \p ground under \p gravity with the timestep \p h.
[[nodiscard]] std::vector<Flight> measureFlights(const QString *program, const Ground &ground,
                                                 Vec2 gravity, double h);

/// The second step of a circle \p i that starts as in the first of those flights, while all others
/// rest elsewhere.
[[nodiscard]] std::optional<Flight::Step> measureWhileOthersRest(const QString *program,
                                                                 const Ground &ground, Vec2 gravity,
                                                                 double h, std::size_t i);

/// The second step of a circle \p i that starts as in the first of those flights, with that
/// restitution.
[[nodiscard]] std::optional<Flight::Step> measureWithRestitution(const QString *program,
                                                                 const Ground &ground, Vec2 gravity,
                                                                 double h, std::size_t i,
                                                                 double restitution);

/// The first step of a circle \p i without gravity, \p slower times as fast as in the first of
/// those flights.
[[nodiscard]] std::optional<Flight::Step> measureSlowStart(const QString *program,
                                                           const Ground &ground, double slower,
                                                           double h, std::size_t i);

/// Which of the first steps of a run are looked at: as they come, or each from the start again, so
/// that only what a program keeps makes them differ.
enum class FirstSteps { Going, Repeated };
/// The first \p count steps of a circle \p i that starts as in the first of those flights, as many
/// as the program makes away from all walls.
[[nodiscard]] std::vector<Flight::Step> measureFirstSteps(const QString *program,
                                                          const Ground &ground, Vec2 gravity,
                                                          double h, std::size_t i, FirstSteps which,
                                                          int count);

/// One scene of such a flight, to be shown: all circles move.
/// \param speed  of the circles
[[nodiscard]] Stage flightStage(const Ground &ground, Vec2 gravity, double h,
                                Flight::Speed speed = Flight::Speed::Any);

/// The second step of a circle \p i that starts at rest and is wider and denser than the others and
/// those of measureFlights().
[[nodiscard]] std::optional<Flight::Step> measureHeavierFall(const QString *program,
                                                             const Ground &ground, Vec2 gravity,
                                                             double h, std::size_t i);

} // namespace cradle
