// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/wall_rebound_words.h"

#include <algorithm>
#include <cmath>
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

    /// One law for all that comes out wrong, if there is one; else circle by circle and wall by
    /// wall.
    [[nodiscard]] std::vector<LawDeviation> find() const
    {
        const std::vector<std::size_t> odd = oddHits();
        std::vector<LawDeviation> found;
        if (odd.empty()) {
            if (const auto fall = withoutGravity())
                found.push_back(*fall);
            return found;
        }
        std::map<std::pair<int, Wall>, std::vector<std::size_t>> parts;
        for (const std::size_t i : odd)
            parts[{m_own.hits[i].circle, m_own.hits[i].wall}].push_back(i);
        std::map<QString, std::vector<std::size_t>> alike;
        for (const auto &[of, part] : parts) {
            std::vector<std::size_t> &all = alike[wordsOf(part).headline];
            all.insert(all.end(), part.begin(), part.end());
        }
        if (alike.size() == 1 || alike.size() > mostAnswers || wordsOf(odd).isLaw)
            return {told(odd)};
        for (const auto &[headline, part] : alike)
            found.push_back(told(part));
        return found;
    }

private:
    /// More kinds of wrong answers are told as one.
    static constexpr std::size_t mostAnswers = 2;

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
                hit.turned && right.turned
                && (!isNear(hit.back, right.back) || !isNear(hit.along, right.along));
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

    [[nodiscard]] LawDeviation told(const std::vector<std::size_t> &odd) const
    {
        const Whose concerned =
            whose([&](std::size_t i) { return std::find(odd.begin(), odd.end(), i) != odd.end(); });
        const std::size_t at = mostTelling(odd);
        const WallHit &hit = m_own.hits[at];
        const WallHit &right = rightOf(at);
        const ReboundWords words = wordsOf(odd);
        LawDeviation found =
            deviation(words.headline, seenAt(hit, right) + QLatin1Char(' ') + words.why, hit,
                      concerned, Suspect::Formula);
        found.shown = static_cast<int>(odd.size());
        return found;
    }

    /// That a circle does not fall in the step of a hit: at side walls, where that alone changes
    /// the part along the wall.
    [[nodiscard]] std::optional<LawDeviation> withoutGravity() const
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
        const Whose concerned = whose(isMeant);
        if (concerned.circles.empty())
            return std::nullopt;
        const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            return isMeant(static_cast<std::size_t>(&hit - m_own.hits.data()));
        });
        return deviation(
            WallText::tr("In the step of a hit at the %walls gravity does not act on %who"),
            WallText::tr("In a step of %1 s gravity changes the velocity by %2 m/s, in the step of "
                         "a hit, too. When circle %4 was turned at the %3, the part along the wall "
                         "stayed as it was before the step.")
                .arg(briefTimestep(at->stage.preset.timestep),
                     brief(at->stage.preset.timestep * at->stage.preset.gravity),
                     motion::wallName(at->wall))
                .arg(at->circle + 1),
            *at, concerned, Suspect::Formula);
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
