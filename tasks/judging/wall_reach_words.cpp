// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_reach.h"

#include "tasks/checks/figures.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cradle {

namespace {

class ReachJudge : WallReach
{
public:
    explicit ReachJudge(const WallComparison &walls)
        : WallReach(walls)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> find() const
    {
        std::vector<std::pair<QString, Whose>> said;
        std::vector<std::pair<QString, const WallHit *>> bodies;
        for (const int circle : m_own.judged) {
            for (const std::set<Wall> &walls : wallsOfOneLength(circle)) {
                const auto at =
                    std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &h) {
                        return h.circle == circle && walls.contains(h.wall) && isElsewhere(h);
                    });
                if (!rightOf(static_cast<std::size_t>(at - m_own.hits.begin())).fits(at->radius))
                    continue; // the reference does not turn at the rim either
                if (at->step == 1 && brief(at->came) == brief(at->left))
                    continue; // put elsewhere, not turned
                const WallHit &telling = tellingOf(*at);
                const auto [headline, body] = reachWords(telling, circle, walls);
                const auto same =
                    std::find_if(said.begin(), said.end(), [&, h = headline](const auto &s) {
                        return s.first == h && s.second.walls == walls;
                    });
                if (same != said.end()) {
                    same->second.circles.push_back(circle);
                    continue;
                }
                said.push_back({headline, {{circle}, walls}});
                bodies.push_back({body, &telling});
            }
        }
        std::vector<LawDeviation> found;
        for (std::size_t i = 0; i < said.size(); ++i) {
            found.push_back(deviation(said[i].first, bodies[i].first, *bodies[i].second,
                                      said[i].second, Suspect::Reach));
            // A length that is right at some walls and wrong at others has another name.
            const std::vector<int> &circles = said[i].second.circles;
            found.back().family =
                looksAhead(circles.front()) ? QStringLiteral("ahead") : QStringLiteral("reach");
            found.back().shown = shownBy(circles);
            found.back().isEverywhere = wrongWalls(circles.front()).size() > 3;
        }
        return found;
    }

    [[nodiscard]] LawDeviation ofSlow(const WallHit &hit, const std::vector<int> &circles) const
    {
        const auto [headline, body] =
            hit.step == 1
                ? atOnce(hit)
                : std::pair(WallText::tr("Slow hits at the %walls turn %who round too early"),
                            slowly(hit));
        LawDeviation found = deviation(headline, body, hit, {circles, {hit.wall}}, Suspect::Reach);
        found.family = QStringLiteral("reach");
        found.isEverywhere = true;
        return found;
    }

private:
    /// That it is turned before it has flown a step.
    [[nodiscard]] static std::pair<QString, QString> atOnce(const WallHit &hit)
    {
        return {WallText::tr("Something away from every wall changes the velocity of %who"),
                WallText::tr("Thrown towards the %1, circle %6 changed its velocity from %2 to "
                             "%3 m/s in the first step, with its centre still %4 m from that "
                             "wall; its radius is %5 m. Look at the conditions: which of them "
                             "is true away from every wall?")
                    .arg(motion::wallName(hit.wall), brief(hit.came), brief(hit.left),
                         brief(hit.before), brief(hit.radius), QString::number(hit.circle + 1))};
    }

    [[nodiscard]] std::pair<QString, QString> reachWords(const WallHit &hit, int circle,
                                                         const std::set<Wall> &walls) const
    {
        if (const auto ahead = hit.step == 1 ? aheadWords(circle) : std::nullopt)
            return *ahead;
        if (hit.step == 1)
            return atOnce(hit);
        // What a step cannot tell apart is not told.
        const std::vector<WallLength> fitting = fittingLengths(circle, walls);
        if (fitting.size() == 1) {
            QString body = fitting.front().body;
            body.replace(QLatin1String("%1"), brief(hit.radius));
            body.replace(QLatin1String("%2"), brief(fitting.front().distance(hit)));
            body.replace(QLatin1String("%3"), QString::number(hit.circle + 1));
            return {fitting.front().headline, body};
        }
        if (const auto number = numberWords(circle, walls))
            return *number;
        for (const Wall wall : walls) {
            if (!m_own.hasOnePlace(circle, wall))
                return atTimes(circle, wall);
        }
        return {lateOrEarly(circle, walls), between(hit)};
    }

    /// That its centre is turned at one distance, whatever radius it has.
    [[nodiscard]] std::optional<std::pair<QString, QString>>
    numberWords(int circle, const std::set<Wall> &walls) const
    {
        const auto place = oneDistance(circle, walls);
        if (!place)
            return std::nullopt;
        return std::pair(
            WallText::tr("At the %walls a number stands for the radius of %who"),
            WallText::tr("Circle %1 turned when its centre was between %2 and %3 m from the wall, "
                         "with the radius %4 m as with %5 m. Take the radius that the circle has.")
                .arg(QString::number(circle + 1), brief(place->nearest), brief(place->farthest),
                     brief(*place->radii.begin()), brief(*place->radii.rbegin())));
    }

    /// That no place would do for all hits at a wall.
    [[nodiscard]] std::pair<QString, QString> atTimes(int circle, Wall wall) const
    {
        const WallHit *off = nullptr;
        int all = 0;
        int right = 0;
        for (const WallHit &hit : m_own.hits) {
            if (hit.circle != circle || hit.wall != wall || !hit.isAnswered())
                continue;
            ++all;
            right += hit.fits(hit.radius);
            if (!off && isElsewhere(hit))
                off = &hit;
        }
        const bool isEarly = off->reached > off->radius;
        return {
            isEarly ? WallText::tr("Some hits at the %walls turn %who round too early")
                    : WallText::tr("Some hits at the %walls turn %who round too late"),
            between(*off) + QLatin1Char(' ')
                + WallText::tr("Of %1 hits tried there, %2 came at the rim.").arg(all).arg(right)};
    }

    /// That a circle turns where its velocity, without the timestep, takes its rim to the wall.
    [[nodiscard]] std::optional<std::pair<QString, QString>> aheadWords(int circle) const
    {
        const std::vector<const WallHit *> far = secondsAhead(circle);
        if (far.empty())
            return std::nullopt;
        const auto rim = [](double place, const WallHit &hit) { return brief(place - hit.radius); };
        const auto speed = [](const WallHit &hit) {
            return brief(dot(hit.came, outwardNormal(hit.wall)));
        };
        return std::pair(
            WallText::tr("Hits at the %walls turn %who round a whole second too early"),
            WallText::tr("Circle %1 came to the %2 with %3 m/s and turned when its rim was between "
                         "%4 and %5 m from it; with %6 m/s between %7 and %8 m. That is the way of "
                         "a second: a step takes it v Δt further, not v.")
                .arg(QString::number(circle + 1), motion::wallName(far[0]->wall), speed(*far[0]),
                     rim(far[0]->reached, *far[0]), rim(far[0]->before, *far[0]), speed(*far[1]),
                     rim(far[1]->reached, *far[1]), rim(far[1]->before, *far[1])));
    }

    [[nodiscard]] QString lateOrEarly(int circle, const std::set<Wall> &walls) const
    {
        bool early = false;
        bool late = false;
        for (const WallHit &hit : m_own.hits) {
            if (hit.circle != circle || !walls.contains(hit.wall) || !isElsewhere(hit))
                continue;
            (hit.reached > hit.radius ? early : late) = true;
        }
        if (early && late)
            return WallText::tr("Hits at the %walls turn %who round at the wrong place");
        return early ? WallText::tr("Hits at the %walls turn %who round too early")
                     : WallText::tr("Hits at the %walls turn %who round too late");
    }

    /// Between which places a slow one turned, and how much a fast one tells of that.
    [[nodiscard]] QString slowly(const WallHit &hit) const
    {
        const WallHit &fast =
            *std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &other) {
                return other.circle == hit.circle && other.wall == hit.wall;
            });
        const auto speed = [](const WallHit &one) {
            return brief(dot(one.came, outwardNormal(one.wall)));
        };
        return WallText::tr("Circle %1 came to the %2 with %3 m/s and turned when its centre was "
                            "between %4 and %5 m from the wall; its radius is %6 m. With %7 m/s it "
                            "turned at its rim, as far as a step of %8 m shows.")
            .arg(QString::number(hit.circle + 1), motion::wallName(hit.wall), speed(hit),
                 brief(hit.reached), brief(hit.before), brief(hit.radius), speed(fast),
                 brief(std::abs(fast.travel)));
    }

    /// Between which places it turned, in words without distances below zero.
    [[nodiscard]] static QString between(const WallHit &hit)
    {
        const QString text =
            hit.reached >= 0.0
                ? WallText::tr("The radius of circle %1 is %2 m, and at the %3 it turned when its "
                               "centre was between %4 and %5 m from the wall. It should turn when "
                               "its rim is there.")
            : hit.before >= 0.0
                ? WallText::tr("The radius of circle %1 is %2 m, and at the %3 it turned when its "
                               "centre was between %4 m past the wall and %5 m short of it. It "
                               "should turn when its rim is there.")
                : WallText::tr("The radius of circle %1 is %2 m, and at the %3 it turned when its "
                               "centre was between %4 and %5 m past the wall. It should turn when "
                               "its rim is there.");
        const bool isPast =
            hit.reached < 0.0 && hit.before < 0.0; // then the nearer one comes first
        return text.arg(hit.circle + 1)
            .arg(brief(hit.radius), motion::wallName(hit.wall),
                 brief(std::abs(isPast ? hit.before : hit.reached)),
                 brief(std::abs(isPast ? hit.reached : hit.before)));
    }
};

} // namespace

std::vector<LawDeviation> reachDeviations(const WallComparison &walls)
{
    return ReachJudge(walls).find();
}

LawDeviation slowReachDeviation(const WallComparison &walls, const WallHit &hit,
                                const std::vector<int> &circles)
{
    return ReachJudge(walls).ofSlow(hit, circles);
}

} // namespace cradle
