// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tasks/checks/motion.h"
#include "tasks/judging/wall_comparison.h"

#include <algorithm>

namespace cradle {

LawDeviation WallComparison::deviation(const QString &headline, const QString &body,
                                       const WallHit &hit, const std::vector<int> &circles,
                                       Suspect suspect, bool isPosition) const
{
    const QString names = circleNames(circles, m_ground.flights.size());
    QString message = headline + QStringLiteral("\n\n") + body;
    message.replace(QLatin1String("%who"), names);
    return {Aspect::Walls,
            message,
            {hit.stage, std::max<qint64>(hit.step, 1), {hit.circle}, isPosition},
            suspect};
}

QString WallComparison::namesOf(const std::set<Wall> &walls)
{
    QStringList names;
    for (const Wall wall : walls)
        names.append(motion::wallName(wall));
    return names.join(QStringLiteral(", "));
}

QString WallComparison::inBrackets(const std::set<Wall> &walls)
{
    return WallText::tr(" (%1)", "walls").arg(namesOf(walls));
}

namespace {

/// Judges the walls of one program.
class WallJudge : WallComparison
{
public:
    using WallComparison::WallComparison;

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        findMissing();
        findReach();
        findLeap();
        findPutOut();
        if (const auto answer = answerDeviation(*this))
            m_found.push_back(*answer);
        findDisturbed();
        findCorners();
        findNoWayBack();
        if (m_found.empty())
            findSlow();
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const WallHit &hit,
             const std::vector<int> &circles, Suspect suspect, bool isPosition = false)
    {
        m_found.push_back(deviation(headline, body, hit, circles, suspect, isPosition));
    }

    void findMissing()
    {
        std::vector<std::pair<int, std::set<Wall>>> open;
        const WallHit *first = nullptr;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.missed || hit.turned || hit.held || !rightOf(i).turned)
                continue;
            first = first ? first : &hit;
            if (open.empty() || open.back().first != hit.circle)
                open.push_back({hit.circle, {}});
            open.back().second.insert(hit.wall);
        }
        if (open.empty())
            return;
        const bool all = std::all_of(open.begin(), open.end(),
                                     [](const auto &each) { return each.second.size() == 4; });
        std::vector<int> circles;
        for (const auto &[circle, walls] : open)
            circles.push_back(circle);
        if (all) {
            add(WallText::tr("None of the four walls turns %who round"),
                WallText::tr("Thrown at each of the four walls, %1 m/s fast, it goes on through "
                             "them. After every move each circle needs its questions: is its rim "
                             "past a wall?")
                    .arg(brief(
                        length(first->stage.preset.circles[static_cast<std::size_t>(first->circle)]
                                   .body.velocity))),
                as(*first), circles, Suspect::Omission);
            noteMissing(circles);
            return;
        }
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto &[circle, walls] = open[i];
            std::vector<int> same{circle};
            for (std::size_t j = i + 1; j < open.size(); ++j) {
                if (open[j].second == walls)
                    same.push_back(open[j].first);
            }
            std::erase_if(open, [&, w = walls, c = circle](const auto &each) {
                return each.first != c && each.second == w;
            });
            const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const auto &h) {
                return h.circle == same.front() && !h.turned && !h.held && !h.missed;
            });
            add(WallText::tr("These walls do not turn %who round: %1").arg(namesOf(open[i].second)),
                WallText::tr("Thrown there it goes on past the wall. A square has four walls: look "
                             "at the question that your program asks for each."),
                as(*at), same, Suspect::Omission);
            noteMissing(same);
        }
    }

    /// Of the fault that was found last.
    void noteMissing(const std::vector<int> &circles)
    {
        m_found.back().family = QStringLiteral("missing");
        m_found.back().shown = static_cast<int>(
            std::count_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
                return std::find(circles.begin(), circles.end(), hit.circle) != circles.end()
                       && !hit.turned && !hit.held && !hit.missed;
            }));
    }

    /// A hit that does not come, at the step in which it should.
    [[nodiscard]] WallHit as(WallHit missing) const
    {
        for (const WallHit &right : m_right.hits) {
            if (right.circle == missing.circle && right.wall == missing.wall && right.turned) {
                missing.step = right.step;
                break;
            }
        }
        return missing;
    }

    void findReach()
    {
        std::vector<LawDeviation> found = reachDeviations(*this);
        const auto early = slowHits([](const WallHit &hit, const WallHit &right) {
            return hit.turned && hit.reached > hit.radius + 1e-9 && right.fits(right.radius);
        });
        if (found.empty() && !early.empty())
            found.push_back(slowReachDeviation(*this, m_own.slow[early.front()], circlesOf(early)));
        m_isElsewhere = !found.empty();
        m_found.insert(m_found.end(), found.begin(), found.end());
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

    void findDisturbed()
    {
        // What changes in the first step of a throw is no answer of a wall.
        const auto disturbs = [](const WallHit &hit) {
            return hit.disturbs && (hit.step > 1 || hit.fits(hit.radius));
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

    /// Whether that circle is turned at that wall when it is fast.
    [[nodiscard]] bool turnsFast(const WallHit &slow) const
    {
        return std::all_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &h) {
            return h.circle != slow.circle || h.wall != slow.wall || h.turned;
        });
    }

    /// The slow hits of which \p isOff is true, where the fast and the reference's are turned: all
    /// those at the wall of the first.
    template <class IsOff>
    [[nodiscard]] std::vector<std::size_t> slowHits(IsOff isOff) const
    {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < m_own.slow.size(); ++i) {
            const WallHit &hit = m_own.slow[i];
            if (!hit.missed && !hit.held && m_right.slow[i].turned && turnsFast(hit)
                && (found.empty() || m_own.slow[found.front()].wall == hit.wall)
                && isOff(hit, m_right.slow[i]))
                found.push_back(i);
        }
        return found;
    }

    [[nodiscard]] std::vector<int> circlesOf(const std::vector<std::size_t> &slow) const
    {
        std::vector<int> circles;
        for (const std::size_t i : slow)
            circles.push_back(m_own.slow[i].circle);
        return circles;
    }

    static QString speedInto(const WallHit &h)
    {
        return brief(dot(outwardNormal(h.wall),
                         h.stage.preset.circles[static_cast<std::size_t>(h.circle)].body.velocity));
    }

    /// What turns round when it is fast.
    void findSlow()
    {
        const auto open = slowHits([](const WallHit &hit, const WallHit &) { return !hit.turned; });
        if (!open.empty())
            return addSlowOpen(open);
        const auto odd = slowHits([](const WallHit &hit, const WallHit &right) {
            return hit.turned && std::abs(hit.back - right.back) > slowBlur;
        });
        if (!odd.empty())
            addSlowOdd(odd);
    }

    /// Of the share that comes back, where what falls in the step of a slow hit counts most.
    static constexpr double slowBlur = 0.05;

    void addSlowOpen(const std::vector<std::size_t> &open)
    {
        WallHit hit = m_own.slow[open.front()];
        hit.step = m_right.slow[open.front()].step;
        add(WallText::tr("Slow hits at the walls do not turn %who round"),
            WallText::tr("Circle %1 came to the %2 with %3 m/s and went on past it; with "
                         "%4 m/s it is turned round. How fast it comes does not matter: "
                         "what counts is whether its rim is past the wall, and which way "
                         "it moves.")
                .arg(QString::number(hit.circle + 1), motion::wallName(hit.wall), speedInto(hit),
                     speedInto(m_own.hits.front())),
            hit, circlesOf(open), Suspect::Question);
    }

    void addSlowOdd(const std::vector<std::size_t> &odd)
    {
        const WallHit &hit = m_own.slow[odd.front()];
        add(WallText::tr("Slow hits at the walls give %who another share of the speed back"),
            WallText::tr("With e = %1 circle %2 came to the %3 with %4 m/s and left it "
                         "with %5 times that speed; %6 times is right. The factor is the "
                         "same for every speed.")
                .arg(brief(hit.restitution), QString::number(hit.circle + 1),
                     motion::wallName(hit.wall), brief(dot(outwardNormal(hit.wall), hit.came)),
                     brief(hit.back), brief(m_right.slow[odd.front()].back)),
            hit, circlesOf(odd), Suspect::Formula);
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
    const auto [mine, theirs] = std::pair(only(own, right.judged), only(right, own.judged));
    if (mine.judged.empty())
        return {};
    return WallJudge(mine, theirs, ground).judge();
}

} // namespace cradle
