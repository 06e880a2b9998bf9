// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/hit_places.h"
#include "tasks/judging/measured_flight.h"
#include "tasks/judging/occasions.h"

namespace cradle {

/// The velocities of two circles, taken apart along the line of centres (from 1 to 2) and across
/// it, m/s.
struct PairVelocities {
    double along1 = 0.0;
    double across1 = 0.0;
    double along2 = 0.0;
    double across2 = 0.0;

    friend constexpr bool operator==(const PairVelocities &, const PairVelocities &) = default;
};

/// The same, so many times as fast.
[[nodiscard]] constexpr PairVelocities faster(const PairVelocities &v, double times)
{
    return {times * v.along1, times * v.across1, times * v.along2, times * v.across2};
}

/// How two circles are thrown at each other.
struct Meeting {
    double degrees = 0.0;  ///< of the line of centres, from the x axis
    double radius1 = 0.2;  ///< m
    double radius2 = 0.2;  ///< m
    double density1 = 7.8; ///< 1000 kg/m³
    double density2 = 7.8; ///< 1000 kg/m³
    double restitution = 1.0;
    PairVelocities velocities{}; ///< before
    Vec2 middle{0.17, -0.23};    ///< of the two, m

    [[nodiscard]] double sum() const { return radius1 + radius2; }
    [[nodiscard]] double closing() const { return velocities.along1 - velocities.along2; }
};

/// What became of a meeting.
struct PairHit {
    Meeting meeting{};
    bool answered = false;     ///< a velocity changed
    double before = 0.0;       ///< distance of the centres in the state before it was answered, m
    double reached = 0.0;      ///< and what it would have been after that step, m
    double after = 0.0;        ///< and what it was then, m
    Vec2 normal{1.0, 0.0};     ///< line of centres then, from 1 to 2
    Vec2 nextNormal{1.0, 0.0}; ///< and after that step
    Vec2 came1{};              ///< velocities that it was answered with, m/s
    Vec2 came2{};
    Vec2 left1{}; ///< and those that it made
    Vec2 left2{};
    double slowness = 1.0; ///< velocities of the stage are these times so much
    bool parting = false;  ///< they had passed each other, or moved apart already
    bool moved1 = false;   ///< its place was set before, and no velocity changed
    bool moved2 = false;
    bool stopped = false; ///< the program stopped with an error
    bool late = false;    ///< others, coming along the same line, are answered long before
    int leaper = -1;      ///< the circle, from 0, that it put far from its own path
    Vec2 landed{};        ///< and where, m
    std::optional<Misplacement> misplaced{}; ///< what its answer makes of a place, the worst
    int misplacedCircle = 0;                 ///< whose, from 0
    bool again = false;                      ///< of those that part: it was answered again at once
    bool afterRest = false;                  ///< and in a step after one in which they rested
    /// And when they were set so once more; of one after a hit: as the first of a run.
    bool anew = false;
    bool partsInside = false; ///< after that they overlap still, and move apart
    qint64 step = 0;          ///< in which it was answered, from 1
    bool isAtOnce = false;    ///< in the first that was looked at
    Stage stage{};

    /// Whether it was answered when they met, not while they ran through each other.
    [[nodiscard]] bool isMet() const { return answered && !parting && !late; }
    [[nodiscard]] Vec2 push1() const { return left1 - came1; }
    [[nodiscard]] Vec2 push2() const { return left2 - came2; }
    [[nodiscard]] PairVelocities cameParts() const;
    [[nodiscard]] PairVelocities leftParts() const;
    /// Whether they stood along the line that was asked for, so that other programs compare.
    [[nodiscard]] bool isAligned() const;
    /// Whether it was answered by the time that the rims met, or a step later.
    [[nodiscard]] bool isInTime() const;
    /// Whether both pushes act along the line of centres, at the start of the step or at its end.
    [[nodiscard]] bool isAlongCentres() const;
    /// Whether its answer puts them farther from each other than they come by flying on for two
    /// steps, before and after it.
    [[nodiscard]] bool isPutFar() const;
    /// Whether the place of one was set while no velocity changed.
    [[nodiscard]] bool isHeld() const { return moved1 || moved2; }
    /// Whether its answer puts them far into each other, farther than they fly in two steps, before
    /// and after it.
    [[nodiscard]] bool isPutTogether() const;
    /// Whether it was noticed but changed no velocity.
    [[nodiscard]] bool isHeldAlone() const { return isHeld() && !answered; }
    /// A part of a velocity along or across the line of centres without what that line makes by
    /// turning in the step: the first of \p known that is no farther away, else 0 if it is not.
    [[nodiscard]] double seenPart(double part, const std::vector<double> &known = {}) const;
    /// Whether it was answered when the centres were \p distance apart; it may be a step late.
    [[nodiscard]] bool fits(double distance) const;
    /// Speed with which they parted, of that with which they met, along the push on circle 2.
    [[nodiscard]] double rebound() const;
};

/// A push that is not over after the first step with one, head-on: in later steps, in which they
/// come nearer no more, too, and not by the same share of the speed.
struct SpreadPush {
    PairHit first{}; ///< step with a push
    PairHit last{};  ///< came with that, and left as the last step with a push makes it
};

/// Two hits of the same circles one after the other.
struct LaterHit {
    PairHit first{};
    PairHit second{};
    PairHit anew{}; ///< the second as the first of a run

    /// Whether the second comes out otherwise than anew, so that what was before it counts.
    [[nodiscard]] bool isOfHistory() const;
    /// Whether the first was answered with another e, and the second with that of the scene.
    [[nodiscard]] bool isFirstOdd() const;
};

/// A meeting in a long run; whether it comes out right is not known.
struct PairOccasion {
    PairHit hit{};
    Occasion when{};
};

/// The first of the meetings of equal circles, with an e of the middle.
[[nodiscard]] Meeting equalMeeting(const Ground::Pair &asked);

/// That meeting alone, and again and again in one long run of \p program; none where laws move the
/// circles, or the program does not go on from where they are set.
[[nodiscard]] std::vector<PairOccasion>
measurePairAgain(const QString *program, const Ground &ground, const MeasuredFlight &flight);

/// Meetings of all kinds, each in a run of its own, in so short steps that the answers can be read
/// exactly; none where laws move the circles.
[[nodiscard]] std::vector<PairHit> measurePairAnswers(const QString *program, const Ground &ground,
                                                      const MeasuredFlight &flight);

/// Two meetings of circles that fly fast along the line of centres, in steps of the usual length;
/// none where laws move the circles, or both never move.
[[nodiscard]] std::vector<PairHit> measurePairChases(const QString *program, const Ground &ground,
                                                     const MeasuredFlight &flight);

/// How a program answers the meetings of circles 1 and 2.
struct MeasuredPair {
    /// \param flight  of the same program
    MeasuredPair(const QString *program, const Ground &ground, const MeasuredFlight &flight);

    /// The same distances, and the same meetings answered.
    [[nodiscard]] bool contactIsLike(const MeasuredPair &other) const;
    /// The same of those that part, and that meet again.
    [[nodiscard]] bool sequelIsLike(const MeasuredPair &other) const;
    [[nodiscard]] bool responseIsLike(const MeasuredPair &other) const;

    bool isJudged = false; ///< both free flights are known
    /// No meeting is answered in time, and those that part are: what answers equal and unequal
    /// circles, with every e, is seen of such.
    bool areOfParting = false;
    std::vector<PairHit> contacts{}; ///< slowly, from all around: when are they answered?
    /// Where some of these come at a wrong distance, and radii are not varied: with other radii.
    std::vector<PairHit> otherRadii{};
    std::vector<PairHit> modes{};     ///< who comes to whom
    std::vector<PairHit> equals{};    ///< equal circles, e as it is without losses
    std::vector<PairHit> radii{};     ///< one is larger
    std::optional<PairHit> larger{};  ///< where sizes are not varied: two larger equal ones
    std::vector<PairHit> sizes{};     ///< one is larger, where any masses are allowed
    std::vector<PairHit> densities{}; ///< one is denser
    std::vector<PairHit> rebounds{};  ///< the other values of e
    std::vector<PairHit> inSteps{};   ///< head-on, early and late in a step, and in a short one
    std::optional<SpreadPush> spread{};
    std::vector<PairHit> partings{}; ///< they overlap and move apart: nothing should happen
    std::optional<PairHit> twice{};  ///< they met, move apart, and are hit again
    std::optional<PairHit> own{};    ///< the first hit of the student's own scene
    /// Where that does not rebound with its e: the same along another line of centres.
    std::optional<PairHit> ownTurned{};
    int ownContacts = 0;           ///< how often they meet again when a wall sends one back
    bool ranThrough = false;       ///< and whether it ran through the other then
    bool ranThroughAtOnce = false; ///< only from so near a wall that it is back at once
    /// What became of a run that begins just before it ran through, if it did.
    std::optional<PairHit> ranThroughAnew{};
    std::vector<PairHit> varied{};      ///< where some are missed: thrown in many ways
    std::optional<PairHit> opposite{};  ///< and far apart, opposite each other about the origin
    std::optional<PairHit> slow{};      ///< equal circles meet slowly, with an e of the middle
    std::optional<PairHit> fast{};      ///< and so fast that they are deep in each other at once
    std::optional<LaterHit> later{};    ///< two hits with different lines of centres
    std::optional<PairHit> returning{}; ///< if so: circle 2 comes to circle 1 for the first time

private:
    [[nodiscard]] bool answersPartingsAlone() const;
};

/// Whether all equal circles are pushed along the line of centres.
[[nodiscard]] bool arePushedAlong(const MeasuredPair &pair);

} // namespace cradle
