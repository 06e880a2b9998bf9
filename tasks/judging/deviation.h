// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/probe.h"
#include "tasks/lab/check_report.h"

namespace cradle {

/// Where a law shows: a step of a stage, and what was assigned in it.
struct Moment {
    Stage stage{};
    qint64 step = 1;            ///< from 1
    std::vector<int> circles{}; ///< that show it, from 0
    bool isPosition = false;    ///< the place is wrong, not the velocity
    /// The value that was wrong from the start, of the circles or, without one, of the scene.
    std::optional<Assignment::Field> start{};
};

/// What of a program is to blame for a deviation.
enum class Suspect {
    Answer,   ///< what it does
    Formula,  ///< the numbers that it works out
    Question, ///< when, or where
    Reach,    ///< a question: at which distance
    Masses,   ///< what it works out for the circles
    Copy,     ///< a value of the scene that it copied before it was set
    Kept,     ///< a value that it works out once and keeps
    Omission, ///< something that is not there
    Begun,    ///< what its own place or velocity of a circle begins with
};

[[nodiscard]] constexpr bool isOfQuestion(Suspect suspect)
{
    return suspect == Suspect::Question || suspect == Suspect::Reach;
}

/// What a deviation of a hit is about, where that tells a line from others.
enum class Topic {
    Other,
    Direction,   ///< where a push points, or the line along which they come nearer
    Restitution, ///< what e does
    Distance,    ///< how far two circles are apart, not with what that is compared
    Momentum,    ///< that the two pushes are not equal and opposite
    Across,      ///< the parts across the line of centres, of both circles
    Slowness,    ///< of hits with which speeds it is
    Shares,      ///< that what parts two circles is not shared whole
    Timestep,    ///< that it is another one with another timestep
    Rounding,    ///< that it is a whole number
    Depth,       ///< that it is another one where the rims touch early in a step
    Memory,      ///< what is kept of an earlier hit
    Held,        ///< that a wall puts a circle back and leaves its velocity as it was
};

/// One thing in which a program's law is not the one that is asked for.
struct LawDeviation {
    Aspect aspect = Aspect::Motion;
    QString message{}; ///< a headline, an empty line, what was measured; CommonMark
    Moment moment{};
    Suspect suspect = Suspect::Answer;
    int shown = 0;    ///< in how many of the scenes it shows; 0 where that is not counted
    QString family{}; ///< what may become of it when some of it is mended; empty: only the same
    Topic topic = Topic::Other;
    std::optional<Wall> wall{}; ///< the only one that it is about
    bool isEverywhere = false;  ///< of a wall's reach: no wall is known where it is right
    bool isConditional = false; ///< what is asked for comes out right at times
    bool isOfSome = false;      ///< it says itself that not all come out wrong
    bool isMethod = false;      ///< of the motion: which integrator it is
    bool hidesHits = false;     ///< of the motion: hits are not seen through it
    bool hidesWalls = false; ///< of the motion: the first shots at walls do not show what they do
};

/// Two or three digits, enough for a reader; noise of rounding is 0.
[[nodiscard]] QString brief(double value);
[[nodiscard]] QString brief(Vec2 value); ///< "(2, 0)"
/// A timestep: "1/60".
[[nodiscard]] QString briefTimestep(double seconds);

/// "circle 1", "both circles", "circles 1 and 3" of so many.
[[nodiscard]] QString circleNames(const std::vector<int> &circles, std::size_t all);

/// How a factor depends on the timestep h; 1 is right.
struct TimestepPattern {
    enum class Kind {
        Constant,  ///< the same at every h
        Forgotten, ///< 1/h: h is missing
        Squared,   ///< h: once too often
        Divided,   ///< 1/h²: by it in place of times it
        Fixed,     ///< T/h: a number stands for h
        Other
    };
    Kind kind = Kind::Constant;
    double value = 1.0; ///< the constant, or T in s
};

/// \param factors  of each h, what was measured divided by what is right
[[nodiscard]] TimestepPattern patternOf(const std::vector<std::pair<double, double>> &factors);

} // namespace cradle
