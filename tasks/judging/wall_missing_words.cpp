// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"

#include <algorithm>

namespace cradle {

namespace {

/// Finds the walls that turn nothing round.
class MissingJudge : WallComparison
{
public:
    explicit MissingJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> find()
    {
        findLent();
        findMissing();
        return std::move(m_found);
    }

private:
    /// Whether \p hit goes through a wall that turns that of the reference.
    [[nodiscard]] bool isOpen(std::size_t i) const
    {
        const WallHit &hit = m_own.hits[i];
        return !hit.missed && !hit.isAnswered() && rightOf(i).turned;
    }

    /// A hit of that circle at that wall that is answered, or not.
    [[nodiscard]] const WallHit *hitOf(int circle, Wall wall, bool isAnswered) const
    {
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.circle == circle && hit.wall == wall
                && (isAnswered ? hit.isAnswered() : isOpen(i)))
                return &hit;
        }
        return nullptr;
    }

    /// One that is answered there, with the same e if there is one.
    [[nodiscard]] const WallHit &answeredBeside(const WallHit &open) const
    {
        const auto like =
            std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
                return hit.circle == open.circle && hit.wall == open.wall && hit.isAnswered()
                       && hit.restitution == open.restitution;
            });
        return like == m_own.hits.end() ? *hitOf(open.circle, open.wall, true) : *like;
    }

    /// The walls that let a circle through: always, or at times.
    [[nodiscard]] std::set<Wall> openTo(int circle, bool isAlways) const
    {
        std::set<Wall> walls;
        for (const Wall wall : allWalls) {
            if (hitOf(circle, wall, false) && isAlways == !hitOf(circle, wall, true)
                && !lentOf(circle, wall))
                walls.insert(wall);
        }
        return walls;
    }

    /// What is known of the place of another circle that is asked for there.
    [[nodiscard]] const LentWall *lentOf(int circle, Wall wall) const
    {
        const auto at =
            std::find_if(m_own.lent.begin(), m_own.lent.end(), [&](const LentWall &one) {
                return one.hit.circle == circle && one.hit.wall == wall;
            });
        return at == m_own.lent.end() ? nullptr : &*at;
    }

    /// That a wall asks where another circle is.
    void findLent()
    {
        std::vector<std::pair<const LentWall *, Whose>> said;
        for (const LentWall &one : m_own.lent) {
            if (!hitOf(one.hit.circle, one.hit.wall, false))
                continue;
            const auto same = std::find_if(said.begin(), said.end(), [&](const auto &s) {
                return s.first->hit.circle == one.hit.circle && s.first->other == one.other;
            });
            if (same != said.end())
                same->second.walls.insert(one.hit.wall);
            else
                said.push_back({&one, {{one.hit.circle}, {one.hit.wall}}});
        }
        for (const auto &[one, whose] : said) {
            const WallHit &through = *hitOf(one->hit.circle, one->hit.wall, false);
            m_found.push_back(deviation(
                WallText::tr("At the %walls the place of circle %1 is asked for, not that of %who")
                    .arg(one->other + 1),
                WallText::tr("Thrown at the %1 with %2 m/s, circle %3 went on past it. In the "
                             "middle its velocity changed from %4 to %5 m/s, with circle %6 beyond "
                             "that wall. Look at whose place stands in the question.")
                    .arg(motion::wallName(one->hit.wall), brief(thrown(through)))
                    .arg(one->hit.circle + 1)
                    .arg(brief(one->hit.came), brief(one->hit.left))
                    .arg(one->other + 1),
                one->hit, whose, Suspect::Question));
            m_found.back().family = QStringLiteral("missing");
            m_found.back().shown = shownBy(whose.circles);
        }
    }

    void findMissing()
    {
        for (const bool isAlways : {true, false}) {
            std::vector<Whose> open;
            for (const int circle : m_own.judged) {
                const std::set<Wall> walls = openTo(circle, isAlways);
                const auto same = std::find_if(open.begin(), open.end(),
                                               [&](const auto &w) { return w.walls == walls; });
                if (same != open.end())
                    same->circles.push_back(circle);
                else if (!walls.empty())
                    open.push_back({{circle}, walls});
            }
            for (const Whose &each : open) {
                const WallHit &through = *hitOf(each.circles.front(), *each.walls.begin(), false);
                m_found.push_back(isAlways ? always(through, each) : atTimes(through, each));
            }
        }
    }

    /// That walls let circles through.
    [[nodiscard]] LawDeviation always(const WallHit &hit, const Whose &whose) const
    {
        const bool isAll = whose.walls.size() > 1 && whose.walls == allOfThem();
        LawDeviation found =
            isAll ? deviation(
                WallText::tr("At every wall %who went out"),
                (isWithoutGravity(hit)
                     ? WallText::tr("Thrown at each of them without gravity, %who "
                                    "went on through it; at the %1 with %2 m/s. Look "
                                    "at whether your program asks about walls for "
                                    "%who, and whether the answer is ever yes.")
                     : WallText::tr("Thrown at each of them, %who went on through it; at "
                                    "the %1 with %2 m/s. Look at whether your program asks "
                                    "about walls for %who, and whether the answer is ever "
                                    "yes."))
                    .arg(motion::wallName(hit.wall), brief(thrown(hit))),
                as(hit), whose, Suspect::Omission)
                  : deviation(WallText::tr("At the %walls %who went out"),
                              WallText::tr("Thrown at the %1 with %2 m/s, circle %3 went on past "
                                           "it. Look at what your program asks for it, and whether "
                                           "the answer is ever yes.")
                                  .arg(motion::wallName(hit.wall), brief(thrown(hit)))
                                  .arg(hit.circle + 1),
                              as(hit), whose, Suspect::Omission);
        found.family = QStringLiteral("missing");
        found.shown = shownBy(whose.circles);
        return found;
    }

    /// That walls let circles through at times.
    [[nodiscard]] LawDeviation atTimes(const WallHit &hit, const Whose &whose) const
    {
        LawDeviation found =
            deviation(WallText::tr("Some hits of %who at the %walls are not answered"),
                      passedAndAnswered(hit, answeredBeside(hit)) + QLatin1Char(' ')
                          + WallText::tr("Look at what your program asks besides whether the rim "
                                         "is past the wall and the circle moves into it."),
                      as(hit), whose, Suspect::Question);
        found.family = QStringLiteral("missing");
        found.shown = shownBy(whose.circles);
        return found;
    }

    /// One hit that is not answered beside one that is.
    [[nodiscard]] static QString passedAndAnswered(const WallHit &hit, const WallHit &answered)
    {
        const QString circle = QString::number(hit.circle + 1);
        const QString wall = motion::wallName(hit.wall);
        if (hit.restitution != answered.restitution)
            return WallText::tr("Thrown at the %1 with %2 m/s and e = %3, circle %4 went on past "
                                "it; with %5 m/s and e = %6 it did not.")
                .arg(wall, brief(thrown(hit)), brief(hit.restitution), circle,
                     brief(thrown(answered)), brief(answered.restitution));
        return (answered.turned
                    ? WallText::tr("Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past "
                                   "it; with %5 m/s from %6 m it is turned round.")
                    : WallText::tr("Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past "
                                   "it; with %5 m/s from %6 m it is held there."))
            .arg(wall, brief(thrown(hit)), brief(start(hit)), circle, brief(thrown(answered)),
                 brief(start(answered)));
    }

    /// Whether it was thrown without the gravity that the step has.
    [[nodiscard]] bool isWithoutGravity(const WallHit &hit) const
    {
        return hit.stage.preset.gravity == Vec2{} && m_ground.gravities.front() != Vec2{};
    }

    static const Circle &body(const WallHit &hit)
    {
        return hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body;
    }
    static Vec2 thrown(const WallHit &hit) { return body(hit).velocity; }
    static Vec2 start(const WallHit &hit) { return body(hit).position; }

    /// How many hits of these circles go through.
    [[nodiscard]] int shownBy(const std::vector<int> &circles) const
    {
        int shown = 0;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i)
            shown +=
                isOpen(i)
                && std::find(circles.begin(), circles.end(), m_own.hits[i].circle) != circles.end();
        return shown;
    }

    /// A hit that does not come, one of m_own, at the step in which it should.
    [[nodiscard]] WallHit as(const WallHit &missing) const
    {
        WallHit seen = missing;
        seen.step = rightOf(static_cast<std::size_t>(&missing - m_own.hits.data())).step;
        return seen;
    }

    std::vector<LawDeviation> m_found;
};

} // namespace

std::vector<LawDeviation> missingDeviations(const WallComparison &walls)
{
    return MissingJudge(walls).find();
}

} // namespace cradle
