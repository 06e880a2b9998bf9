// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/wall_rebound_words.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace cradle {

namespace {

class AnswerJudge : WallComparison
{
public:
    explicit AnswerJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    /// One law for all that comes out wrong, if there is one; else kind by kind.
    [[nodiscard]] std::vector<LawDeviation> find() const
    {
        const std::vector<std::size_t> odd = oddHits();
        if (odd.empty())
            return withoutGravity();
        std::vector<LawDeviation> found;
        for (const std::vector<std::size_t> &kind : kindsOf(odd)) {
            for (const Whose &each : groupsOf(kind, m_own.hits))
                found.push_back(told(ofThose(kind, each), each));
        }
        return found;
    }

private:
    /// More kinds of wrong answers are not told.
    static constexpr std::size_t mostAnswers = 2;

    /// Circle by circle and wall by wall, those together of which the same is said.
    [[nodiscard]] std::vector<std::vector<std::size_t>>
    kindsOf(const std::vector<std::size_t> &odd) const
    {
        std::map<std::pair<int, Wall>, std::vector<std::size_t>> parts;
        for (const std::size_t i : odd)
            parts[{m_own.hits[i].circle, m_own.hits[i].wall}].push_back(i);
        std::map<QString, std::vector<std::size_t>> alike;
        for (const auto &[of, part] : parts) {
            // Of ranges the numbers are other ones at every wall.
            const ReboundWords words = wordsOf(part);
            std::vector<std::size_t> &all = alike[words.isRange ? QString() : words.headline];
            all.insert(all.end(), part.begin(), part.end());
        }
        const ReboundWords words = wordsOf(odd);
        const bool isRange =
            words.isRange && std::none_of(alike.begin(), alike.end(), [&](const auto &kind) {
                return wordsOf(kind.second).isOfAll;
            });
        if (alike.size() == 1 || words.isLaw || (alike.size() > mostAnswers && isRange))
            return {odd};
        std::vector<std::vector<std::size_t>> kinds;
        kinds.reserve(alike.size());
        for (const auto &[headline, hits] : alike)
            kinds.push_back(hits);
        std::stable_sort(kinds.begin(), kinds.end(),
                         [](const auto &a, const auto &b) { return a.size() > b.size(); });
        kinds.resize(std::min(kinds.size(), mostAnswers));
        return kinds;
    }

    [[nodiscard]] std::vector<std::size_t> ofThose(const std::vector<std::size_t> &hits,
                                                   const Whose &whose) const
    {
        std::vector<std::size_t> some;
        std::copy_if(hits.begin(), hits.end(), std::back_inserter(some), [&](std::size_t i) {
            return std::find(whose.circles.begin(), whose.circles.end(), m_own.hits[i].circle)
                   != whose.circles.end();
        });
        return some;
    }

    /// The hits whose answer is not that of the reference.
    [[nodiscard]] std::vector<std::size_t> oddHits() const
    {
        std::vector<std::size_t> odd;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            const WallHit &right = rightOf(i);
            // It may have come to another place, and have been hit there.
            if ((hit.isLeap() && !right.isLeap()) || (hit.kicks && !right.kicks))
                continue;
            if (hit.isLost || isRightFall(hit))
                continue;
            const bool isOnlyHeld = hit.held && right.turned && !isTurnedElse(hit);
            const bool isTurnedOtherwise =
                hit.turned && right.turned && !answerGap(hit, right).isAlike();
            if (isOnlyHeld || isTurnedOtherwise)
                odd.push_back(i);
        }
        return odd;
    }

    [[nodiscard]] ReboundWords wordsOf(const std::vector<std::size_t> &odd) const
    {
        const std::size_t at = mostTelling(odd);
        ReboundWords words = reboundWords(*this, odd, at);
        words.isLaw &= std::all_of(odd.begin(), odd.end(), [&](std::size_t i) {
            return m_own.hits[i].held == m_own.hits[at].held;
        });
        return words;
    }

    /// The hit that shows most: one with losses, if those are what is wrong.
    [[nodiscard]] std::size_t mostTelling(const std::vector<std::size_t> &odd) const
    {
        return *std::min_element(odd.begin(), odd.end(), [&](auto a, auto b) {
            return std::abs(m_own.hits[a].restitution - 0.5)
                   < std::abs(m_own.hits[b].restitution - 0.5);
        });
    }

    [[nodiscard]] LawDeviation told(const std::vector<std::size_t> &odd, const Whose &whose) const
    {
        const ReboundWords words = wordsOf(odd);
        const auto mixed = words.isOfAll ? std::nullopt : mixedAt(odd);
        const std::size_t at = mixed.value_or(mostTelling(odd));
        const WallHit &hit = m_own.hits[at];
        const QString seen = seenAt(hit, rightOf(at)) + QLatin1Char(' ');
        LawDeviation found =
            mixed ? deviation(WallText::tr("Some hits of %who at the %walls come out wrong"),
                              seen + rightTold(odd, hit.restitution), hit, whose, Suspect::Formula)
                  : deviation(words.headline, seen + words.why, hit, whose, Suspect::Formula);
        found.shown = static_cast<int>(odd.size());
        found.topic = hit.held && !mixed ? Topic::Held : Topic::Other;
        return found;
    }

    /// Whether hit \p i came out right at a wall where a hit of \p odd by the same circle did not.
    [[nodiscard]] bool isRightBeside(std::size_t i, const std::vector<std::size_t> &odd) const
    {
        const WallHit &hit = m_own.hits[i];
        return hit.turned && rightOf(i).turned && std::find(odd.begin(), odd.end(), i) == odd.end()
               && std::any_of(odd.begin(), odd.end(), [&](std::size_t k) {
                      const WallHit &wrong = m_own.hits[k];
                      return wrong.circle == hit.circle && wrong.wall == hit.wall;
                  });
    }

    /// One of \p odd beside which another came out right with the same e.
    [[nodiscard]] std::optional<std::size_t> mixedAt(const std::vector<std::size_t> &odd) const
    {
        const auto at = std::find_if(odd.begin(), odd.end(), [&](std::size_t wrong) {
            for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
                if (m_own.hits[i].restitution == m_own.hits[wrong].restitution
                    && isRightBeside(i, {wrong}) && isRightBeside(i, odd))
                    return true;
            }
            return false;
        });
        return at == odd.end() ? std::nullopt : std::optional(*at);
    }

    /// How many of the hits with that e came out right where some did not.
    [[nodiscard]] QString rightTold(const std::vector<std::size_t> &odd, double e) const
    {
        int right = 0;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i)
            right += m_own.hits[i].restitution == e && isRightBeside(i, odd);
        const auto wrong = std::count_if(
            odd.begin(), odd.end(), [&](std::size_t i) { return m_own.hits[i].restitution == e; });
        return WallText::tr("Of %1 hits tried there, %2 came out right. Look at what your program "
                            "asks there.")
            .arg(right + static_cast<int>(wrong))
            .arg(right);
    }

    /// That a circle does not fall in the step of a hit: at side walls, where that alone changes
    /// the part along the wall.
    [[nodiscard]] std::vector<LawDeviation> withoutGravity() const
    {
        const auto missing = [&](const WallHit &hit) {
            return hit.stage.preset.timestep * hit.stage.preset.gravity.y;
        };
        const auto isSide = [](const WallHit &hit) { return outwardNormal(hit.wall).x != 0.0; };
        const auto isWithout = [&](const WallHit &hit) {
            return std::abs(hit.left.y - hit.came.y + missing(hit)) < 1e-6 * std::abs(hit.came.y);
        };
        const auto isMeant = [&](std::size_t i) {
            const WallHit &hit = m_own.hits[i];
            return isSide(hit) && hit.turned && !hit.missed && std::abs(missing(hit)) > 1e-3
                   && isWithout(hit) && !isWithout(rightOf(i));
        };
        std::vector<LawDeviation> found;
        for (const Whose &each : whose(isMeant)) {
            const auto at =
                std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
                    return hit.circle == each.circles.front()
                           && isMeant(static_cast<std::size_t>(&hit - m_own.hits.data()));
                });
            found.push_back(deviation(
                WallText::tr("In the step of a hit at the %walls gravity does not act on %who"),
                WallText::tr("In a step of %1 s gravity changes the velocity by %2 m/s, in the "
                             "step of a hit, too. When circle %4 was turned at the %3, the part "
                             "along the wall stayed as it was before the step.")
                    .arg(briefTimestep(at->stage.preset.timestep),
                         brief(at->stage.preset.timestep * at->stage.preset.gravity),
                         motion::wallName(at->wall))
                    .arg(at->circle + 1),
                *at, each, Suspect::Formula));
        }
        return found;
    }

    /// Whether that wall turns that circle in another throw: then where or when is what is wrong.
    [[nodiscard]] bool isTurnedElse(const WallHit &held) const
    {
        return std::any_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            return hit.circle == held.circle && hit.wall == held.wall && hit.turned;
        });
    }

    [[nodiscard]] QString seenAt(const WallHit &hit, const WallHit &right) const
    {
        const Vec2 n = outwardNormal(hit.wall);
        const Vec2 t = perpendicular(n);
        const Vec2 good = -right.back * dot(hit.came, n) * n + right.along * dot(hit.came, t) * t;
        const QString text =
            hit.back < -blur()
                ? WallText::tr("Circle %5 came to the %1 with %2 m/s and has %3 m/s after the hit, "
                               "still into it; %4 m/s is right.")
                : WallText::tr("Circle %5 came to the %1 with %2 m/s and left it with %3 m/s; %4 "
                               "m/s is right.");
        return withE(hit)
               + text.arg(motion::wallName(hit.wall), brief(hit.came), briefBeside(hit.left, good),
                          briefBeside(good, hit.left))
                     .arg(hit.circle + 1);
    }
};

} // namespace

std::vector<LawDeviation> answerDeviations(const WallComparison &walls)
{
    return AnswerJudge(walls).find();
}

} // namespace cradle
