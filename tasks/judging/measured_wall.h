// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_flight.h"
#include "tasks/judging/occasions.h"

namespace cradle {

/// A step of a circle, and where free flight would have brought it.
struct WallStep {
    Circle was{};
    Motion now{};
    Motion free{};
    qint64 step = 0; ///< from 1
};

/// A shot at one wall, and what became of it. Lengths in m, seen from the wall inward.
struct WallHit {
    int circle = 0;
    Wall wall = Wall::Right;
    double restitution = 1.0;
    double radius = 0.2;
    double otherRadius = 0.2;
    bool missed = false;  ///< it never came to the wall
    bool turned = false;  ///< its velocity changed at the wall
    bool held = false;    ///< it was put back, but its velocity did not change
    int turnsLater = 0;   ///< how many steps later that points away from the wall; 0: never seen
    double before = 0.0;  ///< of the centre from the wall in the state before it was answered
    double reached = 0.0; ///< and where it would have got in that step
    double travel = 0.0;  ///< way of a step towards the wall
    double back = 0.0;    ///< normal part after / before, turned round: 1 is elastic
    double along = 1.0;   ///< part along the wall after / before
    Vec2 was{};           ///< velocity before that step, m/s
    Vec2 came{};          ///< and that it came with
    Vec2 left{};          ///< and left with
    int again = 0;        ///< how often it was turned towards the wall while it left it
    /// Whether a run that begins with the state before the first of these turns it so, too.
    bool isAgainAnew = false;
    bool turnsBoth = false; ///< a few steps later both parts point back
    bool isLost = false;    ///< it was answered far beyond the wall, where something else came true
    bool stays = false;     ///< it does not come away from the wall
    /// Whether it comes away from the wall though its velocity points into it all that time.
    bool goesBack = false;
    double after = 0.0;                  ///< of the centre from the wall after the answer
    double leap = 0.0;                   ///< from both the old place and where it would have got
    Vec2 landed{};                       ///< where it was after the answer
    bool disturbs = false;               ///< another circle did not fly on freely meanwhile
    bool kicks = false;                  ///< its velocity, too, was changed
    std::optional<WallStep> near{};      ///< on its way to the wall, before its rim was there
    std::optional<WallStep> unchanged{}; ///< after it was turned, as if it had not been
    bool isAnewSo = false;               ///< a run that begins with that step makes it alike
    Motion otherFree{};                  ///< what free flight makes of another circle meanwhile
    Motion otherWas{};                   ///< and where and how fast it was after the step
    qint64 step = 0;                     ///< in which it was answered, from 1
    Stage stage{};

    /// Whether the answer came when the centre was \p distance from the wall; it may be a step
    /// late.
    [[nodiscard]] bool fits(double distance) const;
    /// Whether it was answered when all of it was beyond the wall.
    [[nodiscard]] bool isFar() const { return before < -1.3 * radius - std::abs(travel); }
    /// Whether the wall turned it round or held it when it came.
    [[nodiscard]] bool isAnswered() const { return (turned || held) && !isLost; }
    /// Whether the answer put it further out than it would have got by itself.
    [[nodiscard]] bool isPutOut() const
    {
        return turned && !isLeap() && after < reached - 1e-6 && after < radius - 1e-6;
    }
    /// Whether the answer put it where no way of treating a wall puts it.
    [[nodiscard]] bool isLeap() const { return leap > 4.0 * std::abs(travel) + 1.5 * radius; }
};

/// How far two answers are from each other, in the shares of the speed that are left.
struct AnswerGap {
    Vec2 off{};  ///< x: of back, y: of along
    Vec2 blur{}; ///< what comes of where in that step gravity acts, or whether
    [[nodiscard]] bool isAlike() const { return off.x <= blur.x && off.y <= blur.y; }
};
[[nodiscard]] AnswerGap answerGap(const WallHit &own, const WallHit &right);

/// The e nearest to ½, where e, e² and 1 − e are told apart best but for the last two.
[[nodiscard]] double middleOf(const std::vector<double> &restitutions);

/// A shot in a long run; whether it is right is not known.
struct WallOccasion {
    WallHit hit{};
    Occasion when{};
    bool isSlow = false; ///< see MeasuredWalls::slow
};

/// A circle in the middle that is turned as another is beyond a wall.
struct LentWall {
    WallHit hit{};
    int other = 0; ///< from 0
};

/// A circle that falls onto the floor from near it, and stays there a while.
struct Drop {
    int circle = 0;
    Wall wall = Wall::Bottom; ///< or the ceiling, to which it is thrown slowly
    double restitution = 1.0;
    int again = 0; ///< how often it was turned down while it rose
    /// Whether a run that begins with the state before the first of these turns it so, too.
    bool isAgainAnew = false;
    double depth = 0.0; ///< how deep its rim is below the floor at the end, m
    bool sinks = false; ///< it was less deep before
    qint64 step = 0;    ///< the first such step, or the last of all
    Stage stage{};
};

/// Hits at \p walls in long runs of \p program, with an e of the middle; none where laws move the
/// circles, or the program does not go on from where they are set.
[[nodiscard]] std::vector<WallOccasion> measureWallsAgain(const QString *program,
                                                          const Ground &ground,
                                                          const MeasuredFlight &flight,
                                                          const std::vector<Wall> &walls);

/// How a program answers walls.
struct MeasuredWalls {
    /// \param flight  of the same program
    MeasuredWalls(const QString *program, const Ground &ground, const MeasuredFlight &flight);

    [[nodiscard]] bool isLike(const MeasuredWalls &other) const;

    /// Whether all hits of that circle at that wall that are answered come at one place, of its
    /// centre or of its rim.
    [[nodiscard]] bool hasOnePlace(int circle, Wall wall) const;
    /// Whether all of them that turn it do so when its rim is there.
    [[nodiscard]] bool turnsAtRim(int circle, Wall wall) const;
    /// Where that wall turns a circle of that \p radius, of its centre from the wall, m: as near as
    /// the hits show, if one place would do for all of them, and else at its rim.
    [[nodiscard]] double placeOf(int circle, Wall wall, double radius) const;

    /// Whether that circle is known to be turned by \p wall, far from it, when its centre is
    /// \p distance from it, m.
    [[nodiscard]] bool turnsFarAt(int circle, Wall wall, double distance) const;
    /// How far from the middle circles are turned by no wall, m; infinite where none is known to
    /// turn them far from it.
    [[nodiscard]] double freeRoom() const;

    std::vector<WallHit> hits{}; ///< circle by circle, wall by wall
    std::vector<WallHit>
        corners{};               ///< of those hits both parts should turn; \c along tells the other
    std::vector<WallHit> slow{}; ///< at each wall, with an e of the middle
    /// At each wall, of circles that are not turned at their rim, where radii are varied: all
    /// circles are as large, or as small.
    std::vector<WallHit> alike{};
    /// Where another share of the speed than e comes back: of circles that are twice as dense.
    std::vector<WallHit> denser{};
    std::vector<WallHit> slower{};  ///< and of slower ones, where e is varied
    std::vector<WallHit> slanted{}; ///< and of those that go faster along the wall
    std::vector<WallHit> far{};     ///< of circles that are turned at once: two from far away
    std::vector<WallHit> middle{};  ///< and one from the middle to each wall where they are
    std::vector<LentWall> lent{};   ///< where nothing is answered, if another being there is
    std::vector<Drop> drops{};
    std::vector<int> judged{}; ///< the circles whose free flight is known
    double blur = 1e-3;        ///< of back and along: how far gravity blurs them

private:
    /// Between which places, from a wall, m, all answered hits of a circle were turned.
    struct Between {
        double from = 0.0;
        double to = 0.0;
        /// Else no one place would do for all.
        [[nodiscard]] bool isOnePlace() const { return from <= to + 1e-9; }
    };
    /// \param radii  0: of its centre; 1: of its rim
    [[nodiscard]] Between between(int circle, Wall wall, double radii) const;

    /// Marks those of its hits that are answered far beyond a wall, some here and some there.
    void findLost(int circle);
};

} // namespace cradle
