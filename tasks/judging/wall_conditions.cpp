// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_occasion_words.h"

#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_comparison.h"

#include <map>

namespace cradle {

namespace {

/// Judges hits at walls.
class WallConditions : ConditionComparison
{
public:
    explicit WallConditions(const ConditionComparison &comparison)
        : ConditionComparison(comparison)
    {
    }

    [[nodiscard]] ConditionedAspect judge()
    {
        const std::set<Wall> walls = rightWalls();
        m_again = m_own.wallsAgain({walls.begin(), walls.end()});
        m_rightAgain = m_right.wallsAgain({walls.begin(), walls.end()});
        if (m_again.empty() || m_rightAgain.size() != m_again.size())
            return std::move(m_said);
        countHits();
        const double e = m_rightAgain.front().hit.restitution;
        m_first = first(m_own.walls(), e);
        m_rightFirst = first(m_right.walls(), e);
        // A slow one that is not turned may just not come to where it would be.
        sayWalls(
            mixed(wallSeries([](const WallOccasion &one) { return !one.isSlow || one.hit.turned; },
                             [&](const WallHit &hit, const WallHit &) { return isAnswered(hit); })),
            {ConditionText::tr("Some hits of %who at the %walls are not answered"), answersTold,
             ConditionText::tr("This one was answered: circle %1 at %2 s, at the %3 at %4 m with "
                               "%5 m/s.")},
            [](const LawDeviation &found) { return found.suspect != Suspect::Formula; });
        // What falls in the step of a slow one blurs its answer.
        sayWalls(mixed(told(wallSeries(
                     [&](const WallOccasion &one) { return !one.isSlow && isAnswered(one.hit); },
                     [](const WallHit &hit, const WallHit &right) {
                         return hit.turned && answerGap(hit, right).isAlike();
                     }))),
                 {ConditionText::tr("Some hits of %who at the %walls come out wrong"), triesTold,
                  ConditionText::tr("This one came out right: circle %1 at %2 s, at the %3 at %4 m "
                                    "with %5 m/s.")},
                 [](const LawDeviation &found) { return found.suspect == Suspect::Formula; });
        return std::move(m_said);
    }

private:
    /// What is said of hits of which some are as they should be.
    struct Words {
        QString headline{};
        QString (*told)(const std::vector<Occasion> &tries) = nullptr; ///< which they are
        QString beside{};                                              ///< of one of them
    };

    /// Numbers the hits of the long runs.
    void countHits()
    {
        std::map<std::vector<int>, int> counts;
        for (std::size_t i = 0; i < m_again.size(); ++i) {
            const WallHit &hit = m_again[i].hit;
            if (hit.missed || !m_rightAgain[i].hit.turned)
                continue;
            Occasion &when = m_again[i].when;
            when.number = ++counts[{when.run}];
            when.ownNumber = ++counts[{when.run, hit.circle}];
            when.wallNumber = ++counts[{when.run, hit.circle, static_cast<int>(hit.wall)}];
        }
    }

    /// Whether \p hit is answered where others are at that wall, if one place would do for all of
    /// them, and else at its rim: not far outside, where another condition may have come true.
    [[nodiscard]] bool isAnswered(const WallHit &hit) const
    {
        if (!(hit.turned || hit.held) || hit.isFar())
            return false;
        const double place = m_own.walls().placeOf(hit.circle, hit.wall, hit.radius);
        return hit.before > place - 1.5 * std::abs(hit.travel);
    }

    /// Of hits at the walls, in long runs and at the start of others.
    template <class Takes, class IsRight>
    [[nodiscard]] Series<WallOccasion> wallSeries(Takes takes, IsRight isRight)
    {
        Series<WallOccasion> series;
        const auto take = [&](const std::vector<WallOccasion> &own,
                              const std::vector<WallOccasion> &right) {
            for (std::size_t i = 0; i < std::min(own.size(), right.size()); ++i) {
                // One that changes the other's velocity as well may be a hit of the two.
                const bool isOfBoth = own[i].hit.kicks && !right[i].hit.kicks;
                if (!own[i].hit.missed && !isOfBoth && right[i].hit.turned && takes(own[i]))
                    series.add(own[i], right[i], isRight(own[i].hit, right[i].hit));
            }
        };
        take(m_first, m_rightFirst);
        take(m_again, m_rightAgain);
        return series;
    }

    /// Without those that only seem right: gravity blurs their answer by as much as others are off.
    [[nodiscard]] static Series<WallOccasion> told(const Series<WallOccasion> &series)
    {
        Vec2 least{1.0, 1.0};
        for (std::size_t i = 0; i < series.all.size(); ++i) {
            const AnswerGap gap = answerGap(series.all[i].own->hit, series.all[i].right->hit);
            if (series.when[i].isRight || !series.all[i].own->hit.turned)
                continue;
            least.x = gap.off.x > gap.blur.x ? std::min(least.x, gap.off.x) : least.x;
            least.y = gap.off.y > gap.blur.y ? std::min(least.y, gap.off.y) : least.y;
        }
        Series<WallOccasion> some;
        for (std::size_t i = 0; i < series.all.size(); ++i) {
            const auto &[own, right] = series.all[i];
            const Vec2 blur = answerGap(own->hit, right->hit).blur;
            if (!series.when[i].isRight || (blur.x < least.x && blur.y < least.y))
                some.add(*own, *right, series.when[i].isRight);
        }
        return some;
    }

    /// The hits of short runs with the e of the long one.
    [[nodiscard]] static std::vector<WallOccasion> first(const MeasuredWalls &walls, double e)
    {
        std::vector<WallOccasion> all;
        const auto add = [&](const WallHit &hit, bool isSlow) {
            const Circle &c = hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body;
            const Vec2 n = outwardNormal(hit.wall);
            const double room = hit.stage.preset.halfWidth - c.radius - dot(n, c.position);
            if (hit.restitution != e)
                return;
            all.push_back(
                {hit, {.time = room / dot(c.velocity, n), .place = c.position + room * n}, isSlow});
            all.back().when.comesWith(c.velocity, n);
            const auto &bodies = hit.stage.preset.circles;
            if (bodies.size() > 1)
                all.back().when.otherVelocity = bodies[hit.circle == 0 ? 1 : 0].body.velocity;
        };
        for (const WallHit &hit : walls.hits)
            add(hit, false);
        for (const WallHit &hit : walls.slow)
            add(hit, true);
        return all;
    }

    /// Without those of circles and walls that are always right; empty where it is only these that
    /// count.
    [[nodiscard]] static Series<WallOccasion> mixed(const Series<WallOccasion> &series)
    {
        std::set<std::pair<int, Wall>> wrong;
        bool isMixed = false;
        for (std::size_t i = 0; i < series.all.size(); ++i) {
            const WallHit &hit = series.all[i].own->hit;
            if (!series.when[i].isRight)
                wrong.insert({hit.circle, hit.wall});
        }
        const auto isOfWrong = [&](const WallOccasion &seen) {
            return wrong.contains({seen.hit.circle, seen.hit.wall});
        };
        for (const auto &[circle, wall] : wrong) {
            const auto some = series.those([&, c = circle, w = wall](const WallOccasion &seen) {
                return seen.hit.circle == c && seen.hit.wall == w;
            });
            isMixed |= rightOnes(some.when) > 0;
        }
        Series<WallOccasion> judged = isMixed ? series.those(isOfWrong) : Series<WallOccasion>{};
        std::map<int, int> counts;
        for (Occasion &when : judged.when) {
            if (when.run != 0)
                when.likeNumber = ++counts[when.run];
        }
        return judged;
    }

    /// The walls of those that do not come out right.
    [[nodiscard]] static std::set<Wall> wrongWalls(const Series<WallOccasion> &series)
    {
        std::set<Wall> walls;
        for (std::size_t i = 0; i < series.all.size(); ++i) {
            if (!series.when[i].isRight)
                walls.insert(series.all[i].own->hit.wall);
        }
        return walls;
    }

    /// The walls at which the reference turns circles.
    [[nodiscard]] std::set<Wall> rightWalls() const
    {
        std::set<Wall> walls;
        for (const WallHit &hit : m_right.walls().hits) {
            if (hit.turned)
                walls.insert(hit.wall);
        }
        return walls;
    }

    /// Whether circles that answer each other where they do not touch may do so as one comes to a
    /// wall: then what is odd there at times, and in no run in which they stay apart, is theirs.
    [[nodiscard]] bool mayBeOfTheTwo() const
    {
        return m_ground.pair.asked && m_said.deviations.empty()
               && !contactDeviations(m_own.pair(), m_right.pair(), m_ground).empty();
    }

    template <class IsReplaced>
    void sayWalls(const Series<WallOccasion> &series, const Words &words, IsReplaced isReplaced)
    {
        const auto condition = conditionOf(series.when);
        // Where nothing divides them, what was found tells more, if it is true of all.
        const bool isDenied = std::any_of(
            m_said.deviations.begin(), m_said.deviations.end(),
            [](const LawDeviation &found) { return found.suspect == Suspect::Omission; });
        if (!condition
            || (condition->kind == Condition::Kind::Sometimes && !m_said.deviations.empty()
                && !isDenied))
            return;
        // What hangs on the other circle is a fault of the contact.
        if (condition->kind == Condition::Kind::Setting && m_ground.pair.asked) {
            m_said.deviations.clear();
            return;
        }
        if (condition->kind == Condition::Kind::Sometimes && mayBeOfTheTwo())
            return;
        const auto &[own, right] = series.firstWrong();
        const std::set<Wall> walls = wrongWalls(series);
        const std::set<Wall> all = rightWalls();
        const bool isLate = own->hit.turned && !isAnswered(own->hit);
        QString line =
            isLate ? ConditionText::tr("Some hits of %who at the %walls are answered too late")
                   : words.headline;
        line.replace(QLatin1String("%walls"), wallNames(walls.size() == 1 ? walls : all, all));
        QString seen = seenAtWall(*own, *right, isLate);
        if (triedPhrase(*condition).isEmpty())
            seen += rightAtWall(series, own->hit, words.beside);
        say(Aspect::Walls, {line, seen, words.told(series.when)}, *condition,
            series.wrongCircles([](const WallOccasion &one) { return one.hit.circle; }),
            {.stage = own->hit.stage, .step = std::max(own->hit.step, right->hit.step)},
            isReplaced);
    }

    std::vector<WallOccasion> m_first{}; ///< in short runs
    std::vector<WallOccasion> m_rightFirst{};
    std::vector<WallOccasion> m_again{}; ///< in long ones
    std::vector<WallOccasion> m_rightAgain{};
};

} // namespace

ConditionedAspect conditionedWalls(const ConditionComparison &comparison)
{
    return WallConditions(comparison).judge();
}

} // namespace cradle
