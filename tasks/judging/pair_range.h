// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/likeness.h"
#include "tasks/judging/long_run.h"
#include "tasks/judging/measured_pair.h"
#include "tasks/judging/pair_paths.h"

#include <array>
#include <map>

namespace cradle {

/// Throws circles at each other and looks.
class PairRange
{
public:
    PairRange(const QString *program, const Ground &ground, const MeasuredFlight &flight);

    /// Whether it is known how each of them goes on by the velocities of both.
    [[nodiscard]] bool isKnown() const { return m_paths.areKnown(); }

    /// Whether they go as far as they should, so that the own scene can be read.
    [[nodiscard]] bool isUsual() const
    {
        return isEven() && isAlike(m_paths.slowness(m_h), 1.0, 0.05);
    }

    /// Whether both go as far by their own velocities, one as the other; else long runs, in which
    /// nobody sets them before every step, show nothing.
    [[nodiscard]] bool isEven() const { return m_paths.areEven(); }

    /// Comes from far in steps of the usual length.
    [[nodiscard]] PairHit scan(const Meeting &meeting) const;

    /// The same in so short steps that the answer can be read exactly.
    [[nodiscard]] PairHit look(const Meeting &meeting) const;

    /// Comes from a step or two away.
    [[nodiscard]] PairHit approach(const Meeting &meeting) const;

    /// Overlaps and moves apart: one step.
    [[nodiscard]] PairHit part(const Meeting &meeting) const;

    /// The same circles deep in each other, with the velocities turned round, so that they move
    /// apart: one short step, judged as a hit of circles that meet.
    [[nodiscard]] PairHit parted(Meeting meeting) const;

    /// In many ways, each in a run of its own: from all sides, here and there, one of them or both
    /// coming, of all sizes that the step asks about.
    [[nodiscard]] std::vector<PairHit> varied(double restitution) const;

    /// Far from each other, where the sum of their places is less than \p radius, m: that they are
    /// answered in the first step; nothing if they are not, or elsewhere, too.
    [[nodiscard]] std::optional<PairHit> opposite(double radius) const;

    /// As many, in so short steps that the answers can be read exactly; half of them are fast, and
    /// one in three has another e.
    [[nodiscard]] std::vector<PairHit> answers() const;

    /// Both fly fast along the line of centres, the one behind a little faster: circle 2 ahead,
    /// then circle 1.
    [[nodiscard]] std::vector<PairHit> chases() const;

    /// Head-on, with that e: in two steps of the usual length, whose rims touch early in one and
    /// late in the other, and in a very short one.
    [[nodiscard]] std::vector<PairHit> inSteps(Meeting meeting, double restitution) const;

    /// Whether the push of \p model, a hit in steps of the usual length, goes on over several of
    /// them; nothing if it is over after the first with one, or later ones are by the same law.
    [[nodiscard]] std::optional<SpreadPush> spread(const PairHit &model) const;

    /// The same meeting in one long run, here and there, early and late.
    /// \param model  what look() shows of it at the start of a run
    [[nodiscard]] std::vector<PairOccasion> again(const PairHit &model) const;

    /// The first hit of the pair in the student's own scene.
    [[nodiscard]] std::optional<PairHit> own() const;
    /// That hit in the same scene along another line of centres: circles are set just before it.
    [[nodiscard]] std::optional<PairHit> ownTurned(const PairHit &own) const;

    /// Circle 2, pushed, comes back from the wall behind it: how often they meet, and whether it
    /// runs through circle 1.
    void meetAgain(MeasuredPair &pair) const;

    /// A hit of circles that move apart, a few steps after they have met; nothing if there is none.
    [[nodiscard]] std::optional<PairHit> twice(const Meeting &meeting) const;

    /// Two hits with different lines of centres: equal circles, of which 2 comes back from a wall
    /// while 1 drifts to one side.
    [[nodiscard]] std::optional<LaterHit> later(double radius, double density, double e) const;

private:
    /// The first step of two that are far from each other.
    [[nodiscard]] PairHit afar(Vec2 place, Vec2 velocity, Vec2 other, double radius) const;
    [[nodiscard]] int stepsAfter(const PairHit &model) const;
    /// Lets them meet in the midst of a run. \return false if that comes to nothing
    bool meetIn(LongRun &run, PairOccasion &meeting) const;
    /// The same with circle 2 at x = \p place, m.
    /// \param tooNear  so near the centres come only if nothing is answered in time, m
    void comeBack(MeasuredPair &pair, double place, double tooNear) const;
    /// What becomes of \p circles, who come nearer, in a run that begins there.
    [[nodiscard]] PairHit anew(const std::vector<Circle> &circles, double restitution) const;
    /// Whether the step of \p probe from \p before changed a velocity that free flight does not.
    [[nodiscard]] bool isTurned(const std::vector<Circle> &before, const Probe &probe) const;
    [[nodiscard]] bool isAnsweredAgain(const PairHit &hit) const;
    [[nodiscard]] bool isAnsweredAnew(const PairHit &hit) const;
    [[nodiscard]] bool isAnsweredAfterRest(const PairHit &hit) const;
    /// The same without what does not bring them nearer.
    static Meeting straight(Meeting meeting);
    /// \param distance  of the centres at the start, m
    /// \param aim       when they are so far apart, they stand along the line that is asked for, m
    [[nodiscard]] Stage stageOf(const Meeting &m, double distance, double aim, double h) const;
    static constexpr double shortStep = PairPaths::shortStep; ///< s
    static constexpr int fewSteps = 8;

    [[nodiscard]] PairHit meet(const Meeting &meeting, double distance, double aim, double h,
                               int most = 400) const;

    static bool isNearWall(const Circle &c, double way = 0.0);

    void note(PairHit &hit, const std::vector<Circle> &before, const Probe &probe, int k,
              Vec2 gravity = {}) const;

    /// Whether a circle was put farther from its path than any way of parting two puts it.
    void noteLeap(PairHit &hit, int circle, Vec2 before, Vec2 free, const Circle &now) const;

    /// What the answer of \p hit made of the places in the step from \p before.
    void notePlaces(PairHit &hit, const std::vector<Circle> &before, const Probe &probe,
                    Vec2 gravity) const;

    const QString *m_program;
    const Ground &m_ground;
    PairPaths m_paths;
    double m_h;
    /// Where circles of these radii were answered at that angle, if not where their rims meet, m.
    mutable std::map<std::array<double, 3>, double> m_seen{};
};

} // namespace cradle
