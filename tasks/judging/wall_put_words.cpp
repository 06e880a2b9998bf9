// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges where hits at walls put circles, and in which step.
class PutJudge : WallComparison
{
public:
    /// \param isElsewhere  walls turn circles at another place than the rim
    PutJudge(const WallComparison &walls, bool isElsewhere)
        : WallComparison(walls)
        , m_isElsewhere(isElsewhere)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> find()
    {
        findRestarted();
        if (!m_found.empty())
            return std::move(m_found);
        findLeap();
        findPutOut();
        findLate();
        if (!m_isElsewhere)
            findLifted();
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const WallHit &hit, const Whose &whose,
             Suspect suspect, bool isPosition = false)
    {
        m_found.push_back(deviation(headline, body, hit, whose, suspect, isPosition));
    }

    /// What is wrong with the place of a hit, of all hits of which \p is is true and not of the
    /// reference's.
    template <class Is>
    [[nodiscard]] std::vector<Whose> misplaced(Is is) const
    {
        return whose([&](std::size_t i) {
            const bool isToldAlready = m_isElsewhere && m_own.hits[i].step == 1;
            return is(m_own.hits[i]) && !is(rightOf(i)) && !isToldAlready;
        });
    }

    [[nodiscard]] const WallHit &firstOf(const Whose &whose, bool (*is)(const WallHit &)) const
    {
        return *std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            return hit.circle == whose.circles.front() && whose.walls.contains(hit.wall) && is(hit);
        });
    }

    /// That hits put circles back to where they started from, which they left long before.
    void findRestarted()
    {
        const auto isAtStart = [](const WallHit &hit) {
            const Vec2 start =
                hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body.position;
            return hit.turned && hit.step > 2
                   && std::abs(dot(outwardNormal(hit.wall), hit.landed - start)) < 1e-9;
        };
        for (const Whose &whose : misplaced(isAtStart)) {
            const WallHit &hit = firstOf(whose, isAtStart);
            add(WallText::tr("Hits at the %walls put %who back to the start of the run"),
                WallText::tr("At the %1 the centre of circle %3 was put %2 m from the wall, as far "
                             "as it was when the run began. The old place is that before the step: "
                             "keep it anew in every step.")
                    .arg(motion::wallName(hit.wall), brief(hit.after))
                    .arg(hit.circle + 1),
                hit, whose, Suspect::Kept, true);
        }
    }

    void findLeap()
    {
        const auto leaps = [](const WallHit &hit) { return hit.isLeap(); };
        for (const Whose &whose : misplaced(leaps))
            addLeap(firstOf(whose, leaps), whose);
    }

    void addLeap(const WallHit &hit, const Whose &whose)
    {
        const double toOther = std::min(length(hit.landed - hit.otherFree.position),
                                        length(hit.landed - hit.otherWas.position));
        const bool isOther = m_own.judged.size() > 1 && toOther < nearOther;
        add(WallText::tr("Hits at the %walls put %who somewhere else"),
            WallText::tr("At the %1 circle %4 was put %2 m away from its own path, at %3 m.")
                    .arg(motion::wallName(hit.wall), brief(hit.leap), brief(hit.landed))
                    .arg(hit.circle + 1)
                + QLatin1Char(' ')
                + (isOther ? WallText::tr("There the other circle was: each circle goes back to "
                                          "its *own* place.")
                           : WallText::tr("It belongs where its rim is at the wall, or back where "
                                          "it was before that step.")),
            hit, whose, Suspect::Answer, true);
    }

    /// Put further out than it would have got by itself.
    void findPutOut()
    {
        const auto isOut = [](const WallHit &hit) { return hit.isPutOut(); };
        for (const Whose &whose : misplaced(isOut)) {
            const WallHit &hit = firstOf(whose, isOut);
            add(WallText::tr("Hits at the %walls put %who further out"),
                WallText::tr("At the %1 the centre of circle %5 would have come to %2 m from the "
                             "wall and was put %3 m from it; its radius is %4 m. Put it where its "
                             "rim is at the wall, or back where it came from.")
                    .arg(motion::wallName(hit.wall), brief(hit.reached), brief(hit.after),
                         brief(hit.radius))
                    .arg(hit.circle + 1),
                hit, whose, Suspect::Answer, true);
        }
    }

    /// Turned in the step after that in which its rim came past the wall: it went on in that.
    void findLate()
    {
        const auto isLate = [](const WallHit &hit) {
            const double some = 0.1 * std::abs(hit.travel);
            return hit.turned && !hit.isLeap() && hit.fits(hit.radius)
                   && hit.before < hit.radius - some && hit.after < hit.before - some;
        };
        const auto areLate = [&](const WallHit &one) {
            return isLate(one)
                   && std::all_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
                          return hit.circle != one.circle || hit.wall != one.wall || hit.missed
                                 || isLate(hit);
                      });
        };
        for (const Whose &whose : misplaced(areLate)) {
            const WallHit &hit = firstOf(whose, isLate);
            add(WallText::tr("Hits at the %walls turn %who round a step too late"),
                WallText::tr("At the %1 the rim of circle %2 was %3 m past the wall before the "
                             "step in which it was turned round, and %4 m after it. Turn it in "
                             "the step in which its rim comes past the wall.")
                    .arg(motion::wallName(hit.wall), QString::number(hit.circle + 1),
                         brief(hit.radius - hit.before), brief(hit.radius - hit.after)),
                hit, whose, Suspect::Question);
        }
    }

    /// Put further in than any way back puts it.
    void findLifted()
    {
        const auto isLifted = [](const WallHit &hit) {
            const double travel = std::max(1.0, std::abs(hit.back)) * std::abs(hit.travel);
            return hit.turned && !hit.isLeap()
                   && hit.after > std::max(hit.before, hit.radius) + travel + 1e-3;
        };
        for (const Whose &whose : misplaced(isLifted)) {
            const WallHit &hit = firstOf(whose, isLifted);
            add(WallText::tr("Hits at the %walls put %who too far in"),
                WallText::tr("At the %1 the centre of circle %5 was %2 m from the wall before that "
                             "step and was put %3 m from it; its radius is %4 m, so that there is "
                             "a gap. Put it where its rim is at the wall, or back where it came "
                             "from.")
                    .arg(motion::wallName(hit.wall), brief(hit.before), brief(hit.after),
                         brief(hit.radius))
                    .arg(hit.circle + 1),
                hit, whose, Suspect::Answer, true);
        }
    }

    /// Two that stand at one place, m: more than one of them goes in a step.
    static constexpr double nearOther = 0.05;

    bool m_isElsewhere;
    std::vector<LawDeviation> m_found;
};

} // namespace

std::vector<LawDeviation> putDeviations(const WallComparison &walls, bool isElsewhere)
{
    return PutJudge(walls, isElsewhere).find();
}

} // namespace cradle
