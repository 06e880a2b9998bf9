// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/long_run.h"
#include "tasks/judging/measured_wall.h"

namespace cradle {

/// What is shot in long runs: at which walls, with which e.
struct WallShots {
    std::vector<Wall> walls{};
    double restitution = 1.0;
};

/// Shoots circles at walls and looks.
class WallRange
{
public:
    WallRange(const QString *program, const Ground &ground, const MeasuredFlight &flight);

    /// Whether shots of that circle can be aimed: it comes to a wall by its velocity.
    [[nodiscard]] bool isKnown(int circle) const;
    /// By how much what falls in the step of a hit blurs ratios of velocities.
    [[nodiscard]] double blur() const { return !m_falls ? 1e-3 : m_h < m_usual ? 0.005 : 0.05; }
    [[nodiscard]] bool canDrop(int circle) const;

    [[nodiscard]] const Flight &flightOf(int circle) const;

    /// \param place  which of two places, speeds, ways along the wall, and sizes: of the first the
    ///               circle is the larger one, of the second the other, where radii are varied
    [[nodiscard]] WallHit shoot(int circle, Wall wall, double e, int place, bool corner) const;

    /// As the first of the two, while all circles are as large, or all as small.
    [[nodiscard]] WallHit shootAmongAlike(int circle, Wall wall, double e, bool large) const;

    /// As the first of the two, of a circle that is twice as dense.
    [[nodiscard]] WallHit shootDenser(int circle, Wall wall, double e) const;

    /// As the first of the two, with the speed of the second.
    [[nodiscard]] WallHit shootSlower(int circle, Wall wall, double e) const;

    /// As the first of the two, faster along the wall and as fast into it.
    [[nodiscard]] WallHit shootSlanted(int circle, Wall wall, double e) const;

    /// From the middle, for circles that are turned as soon as they are shot from near the wall.
    [[nodiscard]] WallHit comeFromMiddle(int circle, Wall wall, double e) const;

    /// So slowly that a program may take it for rest, from near the wall.
    [[nodiscard]] WallHit creep(int circle, Wall wall, double e) const;

    /// From so far that one that looks a second ahead is not there yet.
    [[nodiscard]] WallHit comeFromFar(int circle, double speed) const;

    /// Whether a circle in the middle is turned while another is beyond that wall, on its way in.
    [[nodiscard]] std::optional<LentWall> lend(int circle, Wall wall, double e) const;

    /// A slow throw at the ceiling, in the longest steps: it comes back by less than it overshot.
    [[nodiscard]] Drop lob(int circle, double e, double speed) const;

    [[nodiscard]] Drop drop(int circle, double e, double height) const;

    /// Shots of all circles in one long run, here and there, early and late, and first shots in a
    /// run that has lasted long.
    [[nodiscard]] std::vector<WallOccasion> again(const WallShots &shots) const;

    /// The strongest downward gravity of the checks; zero if there is none.
    [[nodiscard]] Vec2 fall() const;

private:
    /// One of them slow, so that the place where it turns is known well. Who goes too far in a
    /// step is thrown more gently: it comes to the wall in as many.
    [[nodiscard]] double speedOf(int circle, int place) const;
    /// Of the circle that is shot: another than that of the others, where radii are varied.
    [[nodiscard]] double largeRadius() const;

    /// How a shot comes to its wall, and where the other circles are meanwhile.
    struct Aim {
        double along = -0.7;     ///< from the middle of the wall, m
        double slant = 0.37;     ///< speed along the wall, of that towards it
        Vec2 others{0.31, 0.47}; ///< velocity of the other circles, m/s
        int setting = 0;         ///< of the others: one of two
        bool corner = false;
        bool isNear = false; ///< it is there in the third step
    };
    Stage stageOf(const WallHit &hit, double speed, double share, const Aim &aim) const;

    /// Moves it along t so that it comes as far past that wall as past the wall of \p n, in the
    /// same step.
    void aimAtCorner(Circle &c, int circle, Vec2 n, double halfWidth) const;

    /// Whether \p c is so near one of the two walls that \p direction points to that it may be hit.
    static bool isNearWall(const Circle &c, Vec2 direction, double halfWidth);

    /// The shot of that number in a long run, not made.
    [[nodiscard]] WallOccasion shotOf(std::size_t number, int circle, const WallShots &shots) const;
    /// Makes it. \return false if the run comes to nothing
    bool shootIn(LongRun &run, WallOccasion &shot) const;

    /// Whether one of the two walls of a corner lets its circle through beside the corner, too.
    [[nodiscard]] bool passesBeside(const WallHit &corner) const;

    void watch(WallHit &hit, bool corner = false) const;
    /// The same in the midst of a run, whose circles are set as the stage has them, up to the
    /// answer.
    /// \param isFirst  its run began with the stage
    void watch(WallHit &hit, Probe &probe, bool corner = false, bool isFirst = false) const;

    /// Whether a step that is not that of free flight does not turn or hold it, either, near the
    /// wall and inside of it.
    static bool goesOnNear(const WallHit &hit, const Circle &was, const Circle &now,
                           const Motion &free);

    /// Whether that step is one of free flight where the same shot begins farther from the wall.
    [[nodiscard]] bool isFreeFarther(const WallHit &hit, int k) const;

    void note(WallHit &hit, const std::vector<Circle> &before, const Circle &now,
              const Motion &free, int k) const;

    /// Whether a run that begins \p from the answer puts the circle where the step after it did.
    [[nodiscard]] bool isSoAnew(const WallHit &hit, const World &from) const;
    /// Whether a run of \p stage that begins with the circles of \p from turns that circle into
    /// \p wall in its first step.
    [[nodiscard]] bool turnsAnew(const Stage &stage, const World &from, int circle,
                                 Wall wall) const;

    /// What happens in the steps after the answer.
    void follow(WallHit &hit, Probe &probe) const;

    /// What became of the other circles, if they are away from all walls, in the same step.
    void lookAtOthers(WallHit &hit, const std::vector<Circle> &before, const Probe &probe) const;

    /// Of a velocity, relative: what no rounding makes.
    static constexpr double wallKick = 1e-6;

    const QString *m_program;
    const Ground &m_ground;
    const MeasuredFlight &m_flight;
    Vec2 m_gravity;
    double m_usual; ///< timestep of the checks, s
    double m_h;     ///< of the shots, s
    bool m_falls = false;
};

} // namespace cradle
