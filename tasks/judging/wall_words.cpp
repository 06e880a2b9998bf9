// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tasks/checks/figures.h"
#include "tasks/judging/wall_comparison.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges the walls of one program.
class WallJudge : WallComparison
{
public:
    using WallComparison::WallComparison;

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        take(nearDeviations(*this));
        if (m_found.empty())
            take(unchangedDeviations(*this));
        // The rest is seen through these.
        if (!m_found.empty())
            return std::move(m_found);
        take(kickedDeviation(*this));
        take(missingDeviations(*this));
        findReach();
        take(putDeviations(*this, m_isElsewhere));
        take(answerDeviations(*this));
        take(disturbedDeviation(*this));
        // What a single wall does wrong a corner shows, too.
        if (m_found.empty())
            take(cornerDeviation(*this));
        findNoWayBack();
        if (m_found.empty())
            take(slowAnswerDeviations(*this));
        if (m_found.empty())
            take(outsideDeviations(*this));
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const WallHit &hit, const Whose &whose,
             Suspect suspect, bool isPosition = false)
    {
        m_found.push_back(deviation(headline, body, hit, whose, suspect, isPosition));
    }

    template <class Deviations>
    void take(const Deviations &found)
    {
        if constexpr (requires { found.begin(); })
            m_found.insert(m_found.end(), found.begin(), found.end());
        else if (found)
            m_found.push_back(*found);
    }

    void findReach()
    {
        const std::size_t before = m_found.size();
        take(reachDeviations(*this));
        if (m_found.size() == before)
            take(slowEarlyDeviation(*this));
        m_isElsewhere = m_found.size() > before;
    }

    void findNoWayBack()
    {
        const bool rightTurns = std::any_of(m_right.drops.begin(), m_right.drops.end(),
                                            [](const Drop &drop) { return drop.again > 0; });
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.again == 0 || rightOf(i).again > 0)
                continue;
            addAgain(hit.wall, {hit.stage, hit.step, {hit.circle}, false}, hit.isAgainAnew);
            return;
        }
        for (std::size_t i = 0; i < m_own.drops.size(); ++i) {
            const Drop &drop = m_own.drops[i];
            if (drop.again > 0 && !rightTurns) {
                addAgain(drop.wall, {drop.stage, drop.step, {drop.circle}, false},
                         drop.isAgainAnew);
                return;
            }
            // A floor that gives all back is not asked to hold what lies on it.
            if (!rebounds() || drop.restitution == 1.0)
                continue;
            // Deeper than what a few steps of gravity can hide.
            const double deep = 0.02;
            if (drop.sinks && drop.depth > deep && m_right.drops[i].depth < deep && m_found.empty()
                && !m_isElsewhere) {
                m_found.push_back(
                    {Aspect::Course,
                     WallText::tr(
                         "The floor does not hold circle %1 up\n\nHere e is %4. After %2 s "
                         "near the floor its rim is %3 m below it, and deeper than "
                         "before: the floor changes its velocity, and yet gravity pulls "
                         "it on. Put the circle back where it touches.")
                         .arg(drop.circle + 1)
                         .arg(brief(static_cast<double>(drop.step) * drop.stage.preset.timestep),
                              brief(drop.depth), brief(drop.restitution)),
                     {drop.stage, drop.step, {drop.circle}, true},
                     Suspect::Answer,
                     0,
                     QStringLiteral("held")});
                return;
            }
        }
    }

    /// \param isAnew  see WallHit::isAgainAnew
    void addAgain(Wall wall, const Moment &moment, bool isAnew)
    {
        // Who turns at another place than the rim may be outside still for that reason alone.
        if (m_isElsewhere)
            return;
        const QString text =
            isAnew ? WallText::tr(
                "Circle %1 was turned round again while it left a wall\n\nIt was on its "
                "way back from the %2 and was turned into it once more. Put it back "
                "inside, or ask which way it moves before you turn it.")
                   : WallText::tr(
                       "Circle %1 was turned round again while it left a wall\n\nIt was on its "
                       "way back from the %2 and was turned into it once more; in a run that "
                       "begins there it goes on. Look at what your program keeps from one step to "
                       "the next.");
        m_found.push_back({Aspect::Walls,
                           text.arg(moment.circles.front() + 1).arg(motion::wallName(wall)), moment,
                           Suspect::Question});
    }

    std::vector<LawDeviation> m_found;
    bool m_isElsewhere = false; ///< walls turn circles at another place than the rim
};

/// Takes out what another circle feels as well and not with \p right: it may be a hit of the two.
void blankKicks(std::vector<WallHit> &hits, const std::vector<WallHit> &right)
{
    for (std::size_t i = 0; i < hits.size() && i < right.size(); ++i) {
        WallHit &hit = hits[i];
        if (!hit.kicks || right[i].kicks || hit.step < 2)
            continue;
        hit.missed = true;
        hit.turned = hit.held = false;
    }
}

/// Takes out what came so far beside the middle that a wall beside it turns it as well, far from
/// that: what comes of both tells nothing of one.
void blankCornered(MeasuredWalls &law)
{
    for (WallHit &hit : law.hits) {
        const Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body;
        const bool isCornered =
            std::any_of(std::begin(allWalls), std::end(allWalls), [&](Wall wall) {
                const Vec2 n = outwardNormal(wall);
                return dot(n, outwardNormal(hit.wall)) == 0.0
                       && law.turnsFarAt(hit.circle, wall,
                                         hit.stage.preset.halfWidth - dot(n, c.position));
            });
        if (!isCornered)
            continue;
        hit.missed = true;
        hit.turned = hit.held = false;
    }
}

/// What \p law says of \p circles.
MeasuredWalls only(MeasuredWalls law, const std::vector<int> &circles)
{
    const auto isOther = [&](const auto &seen) {
        return std::find(circles.begin(), circles.end(), seen.circle) == circles.end();
    };
    std::erase_if(law.hits, isOther);
    std::erase_if(law.corners, isOther);
    std::erase_if(law.slow, isOther);
    std::erase_if(law.drops, isOther);
    std::erase_if(law.judged, [&](int circle) {
        return std::find(circles.begin(), circles.end(), circle) == circles.end();
    });
    return law;
}

} // namespace

std::vector<LawDeviation> wallDeviations(const MeasuredWalls &own, const MeasuredWalls &right,
                                         const Ground &ground)
{
    auto [mine, theirs] = std::pair(only(own, right.judged), only(right, own.judged));
    if (mine.judged.empty())
        return {};
    for (const auto part : {&MeasuredWalls::hits, &MeasuredWalls::corners, &MeasuredWalls::slow}) {
        if (ground.pair.asked)
            blankKicks(mine.*part, theirs.*part);
    }
    blankCornered(mine);
    return WallJudge(mine, theirs, ground).judge();
}

} // namespace cradle
