// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <limits>
#include <optional>
#include <vector>

namespace cradle {

/// One of several things in a long run of a program that differ only in when and where they come:
/// hits at walls, hits of two circles, or steps of free flight.
struct Occasion {
    double time = 0.0;                                      ///< since the run began, s
    int run = 0;                                            ///< of which it is; 0: of its own
    int number = 1;                                         ///< of all those in the run, from 1
    int ownNumber = 1;                                      ///< of those of its circle
    int wallNumber = 1;                                     ///< of these at its wall
    int likeNumber = 1;                                     ///< of all that are judged with it
    double pause = std::numeric_limits<double>::infinity(); ///< since the one before it, s
    Vec2 place{};                                           ///< of the circle or of both, m
    double speed = 0.0;                                     ///< with which it comes, m/s
    double into = 0.0;                                      ///< of that, into a wall
    double along = 0.0;                                     ///< and along it
    Vec2 velocity{};                                        ///< of which it is, of one circle, m/s
    int setting = 0;                                        ///< where the other circles were
    Vec2 otherVelocity{};                                   ///< of another circle meanwhile, m/s
    bool hasMet = false; ///< the two circles have hit each other before
    bool hasHit = false; ///< all circles have hit a wall before
    bool isRight = true;

    /// It comes with that velocity to the wall of that outward normal.
    void comesWith(Vec2 towards, Vec2 normal);
};

/// What those that come out right have in common, and no others.
struct Condition {
    enum class Kind {
        Sometimes, ///< nothing that is known
        First,     ///< it is the first
        NotFirst,  ///< it is not
        FirstFew,  ///< its number in the run is small; the limits are such numbers
        AfterFew,
        OddOnes, ///< the first, the third, and so on
        EvenOnes,
        Pause,     ///< the last one was long ago
        BeforeMet, ///< the circles have not met yet
        BeforeHit, ///< nor hit a wall
        AfterHit,
        Until, ///< a time, s
        From,
        Above, ///< a place, m
        Below,
        LeftOf,
        RightOf,
        Slower, ///< speeds, m/s
        Faster,
        SlowerInto, ///< a wall
        FasterInto,
        SlowerAlong,
        FasterAlong,
        Rightward, ///< ways
        Leftward,
        Upward,
        Downward,
        OtherRightward, ///< ways of another circle meanwhile
        OtherLeftward,
        OtherUpward,
        OtherDownward,
        Setting, ///< it counts where the other circles are
    };
    Kind kind = Kind::Sometimes;
    /// The limit lies between that of the last right one and that of the first wrong one.
    double inside = 0.0;
    double outside = 0.0;
    /// Of which a number is.
    enum class Counted {
        InRun,    ///< all of a run
        OfCircle, ///< those of a circle
        AtWall,   ///< of these those at a wall
    };
    Counted counted = Counted::InRun;

    [[nodiscard]] bool isOfPlace() const
    {
        return kind == Kind::Above || kind == Kind::Below || kind == Kind::LeftOf
               || kind == Kind::RightOf;
    }
    /// What was before it, or how long the run has lasted: nothing of where and how fast.
    [[nodiscard]] bool isOfHistory() const { return kind < Kind::Above; }
};

/// All that divides the right ones of \p occasions from the others: of several none is known to be
/// the one that counts. Which are the first ones is counted in one way only.
[[nodiscard]] std::vector<Condition> conditionsOf(const std::vector<Occasion> &occasions);

/// \return nothing where all of \p occasions come out alike; Sometimes, too, where several things
///         divide them
[[nodiscard]] std::optional<Condition> conditionOf(const std::vector<Occasion> &occasions);

/// How many come out right.
[[nodiscard]] int rightOnes(const std::vector<Occasion> &occasions);

} // namespace cradle
