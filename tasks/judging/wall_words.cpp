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
        findKicked();
        take(missingDeviations(*this));
        findReach();
        findLeap();
        findPutOut();
        if (!m_isElsewhere)
            findLifted();
        take(answerDeviation(*this));
        findDisturbed();
        findCorners();
        findNoWayBack();
        if (m_found.empty())
            take(slowAnswerDeviation(*this));
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const WallHit &hit,
             const std::vector<int> &circles, Suspect suspect, bool isPosition = false)
    {
        m_found.push_back(deviation(headline, body, hit, circles, suspect, isPosition));
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

    void findLeap()
    {
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (!hit.isLeap() || rightOf(i).isLeap())
                continue;
            add(WallText::tr("A hit at a wall puts %who somewhere else"),
                WallText::tr("At the %1 it was put %2 m away from its own path, at %3 m. Each "
                             "circle goes back to its *own* place: look at which position it "
                             "gets.")
                    .arg(motion::wallName(hit.wall), brief(hit.leap), brief(hit.landed)),
                hit, {hit.circle}, Suspect::Answer, true);
            return;
        }
    }

    /// Put further out than it would have got by itself.
    void findPutOut()
    {
        const auto isOut = [](const WallHit &hit) {
            return hit.turned && hit.after < hit.reached - 1e-6 && hit.after < hit.radius - 1e-6;
        };
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (!isOut(hit) || hit.isLeap() || isOut(rightOf(i)))
                continue;
            add(WallText::tr("A hit puts %who further out (%1)").arg(motion::wallName(hit.wall)),
                WallText::tr("Its centre would have come to %1 m from the wall and was put %2 m "
                             "from it; its radius is %3 m. Put it where its rim is at the wall, or "
                             "back where it came from.")
                    .arg(brief(hit.reached), brief(hit.after), brief(hit.radius)),
                hit, {hit.circle}, Suspect::Answer, true);
            return;
        }
    }

    /// A hit that changes the velocity of another circle, too, of which nothing else is told.
    void findKicked()
    {
        const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(),
                                     [](const WallHit &hit) { return hit.kicks && hit.missed; });
        if (at == m_own.hits.end())
            return;
        add(WallText::tr("Beside a wall the velocity of both circles changes at once"),
            WallText::tr(
                "When circle %1 was %2 m from the %3 its velocity changed, and in the same "
                "step that of the other, far from it and from every wall. Look at which "
                "lines run for both, and at what they ask.")
                .arg(QString::number(at->circle + 1), brief(at->before),
                     motion::wallName(at->wall)),
            *at, {at->circle}, Suspect::Question);
    }

    /// Put further in than any way back puts it.
    void findLifted()
    {
        const auto isLifted = [](const WallHit &hit) {
            const double travel = std::max(1.0, std::abs(hit.back)) * std::abs(hit.travel);
            return hit.turned && hit.after > std::max(hit.before, hit.radius) + travel + 1e-3;
        };
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (!isLifted(hit) || hit.isLeap() || isLifted(rightOf(i)))
                continue;
            add(WallText::tr("A hit puts %who away from the wall (%1)")
                    .arg(motion::wallName(hit.wall)),
                WallText::tr("Its centre was %1 m from the wall before that step and was put %2 m "
                             "from it; its radius is %3 m, so that there is a gap. Put it where "
                             "its rim is at the wall, or back where it came from.")
                    .arg(brief(hit.before), brief(hit.after), brief(hit.radius)),
                hit, {hit.circle}, Suspect::Answer, true);
            return;
        }
    }

    void findDisturbed()
    {
        // What changes in the first step of a throw is no answer of a wall.
        const auto disturbs = [](const WallHit &hit) {
            return hit.disturbs && !hit.missed && (hit.step > 1 || hit.fits(hit.radius));
        };
        const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), disturbs);
        const auto leaps = [](const WallHit &hit) { return hit.isLeap(); };
        if (at == m_own.hits.end() || std::any_of(m_own.hits.begin(), m_own.hits.end(), leaps)
            || std::any_of(m_right.hits.begin(), m_right.hits.end(), disturbs))
            return;
        add(WallText::tr("A hit of one circle at a wall also stops the other on its way"),
            WallText::tr("While %1 was answered by the %2, the other circle, far from every wall, "
                         "did not go on freely. Each circle is put back on its own: look at whose "
                         "positions your wall changes.")
                .arg(circleNames({at->circle}, 0), motion::wallName(at->wall)),
            *at, {at->circle}, Suspect::Answer, true);
    }

    void findCorners()
    {
        // What a single wall does wrong a corner shows, too.
        if (!m_found.empty())
            return;
        for (std::size_t i = 0; i < m_own.corners.size(); ++i) {
            const WallHit &hit = m_own.corners[i];
            const WallHit &right = m_right.corners[i];
            if (!right.turnsBoth || hit.missed || !hit.turned || hit.turnsBoth
                || !turnsOnePart(hit))
                continue;
            add(WallText::tr("In a corner only one part of the velocity of %who turns round"),
                WallText::tr("It came with %1 m/s and left with %2 m/s. Both walls are hit in "
                             "the same step, and the "
                             "second must go on from what the first has made, not from the "
                             "velocity before.")
                    .arg(brief(hit.came), brief(hit.left)),
                hit, {hit.circle}, Suspect::Answer);
            return;
        }
    }

    /// Whether one part of the velocity was turned round, and the other goes on.
    static bool turnsOnePart(const WallHit &hit)
    {
        const bool x = hit.came.x * hit.left.x < 0.0;
        const bool y = hit.came.y * hit.left.y < 0.0;
        return (x && hit.came.y * hit.left.y > 0.0) || (y && hit.came.x * hit.left.x > 0.0);
    }

    void findNoWayBack()
    {
        const bool rightTurns = std::any_of(m_right.drops.begin(), m_right.drops.end(),
                                            [](const Drop &drop) { return drop.again > 0; });
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.again == 0 || rightOf(i).again > 0)
                continue;
            addAgain(hit.circle, hit.stage, hit.step);
            return;
        }
        for (std::size_t i = 0; i < m_own.drops.size(); ++i) {
            const Drop &drop = m_own.drops[i];
            if (drop.again > 0 && !rightTurns) {
                addAgain(drop.circle, drop.stage, drop.step);
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
                     WallText::tr("The floor does not hold circle %1 up\n\nAfter %2 s near the "
                                  "floor its rim is %3 m below it: it turns, but nothing puts it "
                                  "back, and gravity pulls it deeper in every step. Put the circle "
                                  "back where it touches.")
                         .arg(drop.circle + 1)
                         .arg(brief(static_cast<double>(drop.step) * drop.stage.preset.timestep),
                              brief(drop.depth)),
                     {drop.stage, drop.step, {drop.circle}, true}});
                return;
            }
        }
    }

    void addAgain(int circle, const Stage &stage, qint64 step)
    {
        // Who turns at another place than the rim may be outside still for that reason alone.
        if (m_isElsewhere)
            return;
        m_found.push_back(
            {Aspect::Walls,
             WallText::tr("Circle %1 is turned round again while it leaves the wall\n\nIts rim was "
                          "still outside, it moved inward already, and it was turned into the wall "
                          "once more: in a low drop or after a slow hit. Put it back inside, or "
                          "ask which way it moves before you turn it.")
                 .arg(circle + 1),
             {stage, step, {circle}, false},
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
    return WallJudge(mine, theirs, ground).judge();
}

} // namespace cradle
