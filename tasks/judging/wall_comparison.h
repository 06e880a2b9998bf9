// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_wall.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>

namespace cradle {

struct WallText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// Behind "at the": "floor", "left wall and floor"; "walls" where they are \p all that count.
[[nodiscard]] QString wallNames(const std::set<Wall> &walls, const std::set<Wall> &all);

/// The walls of a program beside those of the reference.
class WallComparison
{
public:
    WallComparison(const MeasuredWalls &own, const MeasuredWalls &right, const Ground &ground)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
    {
    }

protected:
    /// Of whom something is said.
    struct Whose {
        std::vector<int> circles{}; ///< from 0, in order
        std::set<Wall> walls{};
    };
    /// \param headline  with %who for the circles and %walls for the walls
    [[nodiscard]] LawDeviation deviation(const QString &headline, const QString &body,
                                         const WallHit &hit, const Whose &whose,
                                         Suspect suspect = Suspect::Answer,
                                         bool isPosition = false) const;
    /// Behind "at the": "floor", "left wall and floor"; "walls" where it is all that turn circles.
    [[nodiscard]] QString namesOf(const std::set<Wall> &walls) const;
    /// Of which hits \p is is true; it gets their numbers.
    template <class Is>
    [[nodiscard]] std::vector<Whose> whose(Is is) const
    {
        std::vector<std::size_t> hits;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            if (is(i))
                hits.push_back(i);
        }
        return groupsOf(hits, m_own.hits);
    }
    /// Whose these hits are, of all that were \p tried: together only circles of which each did so
    /// at each of the walls that it came to.
    [[nodiscard]] std::vector<Whose> groupsOf(const std::vector<std::size_t> &hits,
                                              const std::vector<WallHit> &tried) const;

    /// The hit of the reference in the same stage.
    [[nodiscard]] const WallHit &rightOf(std::size_t i) const { return m_right.hits[i]; }
    /// The walls at which the reference turns circles: in some labs there is only a floor.
    [[nodiscard]] std::set<Wall> allOfThem() const;
    /// e is a word of the steps that ask for it.
    [[nodiscard]] bool rebounds() const { return m_ground.walls.restitutions.size() > 1; }

    /// Whether it was turned as it should be by who falls as asked in that step, before it, after
    /// it or a share of it before: then only the steps without a hit are wrong.
    [[nodiscard]] bool isRightFall(const WallHit &hit) const;

    /// Whether two ratios of velocities are the same but for what gravity blurs, see
    /// MeasuredWalls::blur.
    [[nodiscard]] bool isNear(double a, double b) const;
    [[nodiscard]] double blur() const { return std::max(m_own.blur, m_right.blur); }

    /// "Here e is 0.5. ", where e is a word of the step.
    [[nodiscard]] QString withE(const WallHit &hit) const;

    const MeasuredWalls &m_own;
    const MeasuredWalls &m_right;
    const Ground &m_ground;
};

/// That circles go on otherwise than in free flight before they are at a wall.
[[nodiscard]] std::vector<LawDeviation> nearDeviations(const WallComparison &walls);
/// That circles go on after a hit as if it had not turned them.
[[nodiscard]] std::vector<LawDeviation> unchangedDeviations(const WallComparison &walls);
/// That walls turn nothing round.
[[nodiscard]] std::vector<LawDeviation> missingDeviations(const WallComparison &walls);
/// Where walls turn circles at another place than their rim.
[[nodiscard]] std::vector<LawDeviation> reachDeviations(const WallComparison &walls);
/// That the slow \p hit comes too early, where the fast ones go too far in a step to tell.
[[nodiscard]] LawDeviation slowReachDeviation(const WallComparison &walls, const WallHit &hit,
                                              const std::vector<int> &circles);
/// That slow hits alone come too early.
[[nodiscard]] std::optional<LawDeviation> slowEarlyDeviation(const WallComparison &walls);
/// What walls make of a slow circle that they do not make of a fast one.
[[nodiscard]] std::vector<LawDeviation> slowAnswerDeviations(const WallComparison &walls);
/// A hit that changes the velocity of another circle, too, of which nothing else is told.
[[nodiscard]] std::optional<LawDeviation> kickedDeviation(const WallComparison &walls);
/// A hit in whose step another circle does not go on as it does without one.
[[nodiscard]] std::optional<LawDeviation> disturbedDeviation(const WallComparison &walls);
/// What two walls that are hit at once make of a velocity, where each is right by itself.
[[nodiscard]] std::optional<LawDeviation> cornerDeviation(const WallComparison &walls);
/// What walls make of a velocity that they should not.
[[nodiscard]] std::vector<LawDeviation> answerDeviations(const WallComparison &walls);

/// That hits put circles where they should not be, or a step too late.
/// \param isElsewhere  walls turn circles at another place than the rim
[[nodiscard]] std::vector<LawDeviation> putDeviations(const WallComparison &walls,
                                                      bool isElsewhere);
/// That hits that take speed leave circles so far beyond a wall that no step brings them back.
[[nodiscard]] std::vector<LawDeviation> outsideDeviations(const WallComparison &walls);

} // namespace cradle
