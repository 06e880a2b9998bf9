// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"
#include "tasks/judging/wall_lengths.h"

#include "tasks/checks/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cradle {

namespace {

class ReachJudge : WallComparison
{
public:
    explicit ReachJudge(const WallComparison &walls)
        : WallComparison(walls)
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
    /// Whether a wall answers a circle elsewhere than at its rim. One that is put far off and keeps
    /// its velocity has not been turned.
    [[nodiscard]] static bool isElsewhere(const WallHit &hit)
    {
        return (hit.turned || (hit.held && !hit.isLeap())) && !hit.isLost && !hit.fits(hit.radius);
    }

    /// In place of \p hit, one that shows where the wall turns circles: who is turned before it
    /// has flown a step does not.
    [[nodiscard]] const WallHit &tellingOf(const WallHit &hit) const
    {
        const auto at = std::find_if(m_own.middle.begin(), m_own.middle.end(), [&](const auto &h) {
            return h.circle == hit.circle && h.wall == hit.wall;
        });
        const bool isTelling = hit.step == 1 && at != m_own.middle.end() && at->turned
                               && at->step > 1 && isMirrored(*at) && !looksAhead(hit.circle);
        return isTelling ? *at : hit;
    }

    [[nodiscard]] bool looksAhead(int circle) const
    {
        return std::any_of(m_own.hits.begin(), m_own.hits.end(),
                           [&](const auto &h) {
                               return h.circle == circle && h.step == 1 && isElsewhere(h);
                           })
               && aheadWords(circle);
    }

    /// How many hits of these circles do not come where their rims are.
    [[nodiscard]] int shownBy(const std::vector<int> &circles) const
    {
        return static_cast<int>(
            std::count_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
                return std::find(circles.begin(), circles.end(), hit.circle) != circles.end()
                       && isElsewhere(hit);
            }));
    }

    /// The walls at which a circle turns elsewhere than at its rim.
    [[nodiscard]] std::set<Wall> wrongWalls(int circle) const
    {
        std::set<Wall> walls;
        for (const WallHit &hit : m_own.hits) {
            if (hit.circle == circle && isElsewhere(hit))
                walls.insert(hit.wall);
        }
        return walls;
    }

    /// The walls at which a circle turns elsewhere: together where one length is known by which it
    /// does at all of them, or none of any; else wall by wall.
    [[nodiscard]] std::vector<std::set<Wall>> wallsOfOneLength(int circle) const
    {
        const std::set<Wall> all = wrongWalls(circle);
        if (all.empty())
            return {};
        const auto isKnown = [&](const std::set<Wall> &walls) {
            return fittingLengths(circle, walls).size() == 1;
        };
        if (all.size() == 1 || !fittingLengths(circle, all).empty() || numberWords(circle, all)
            || std::none_of(all.begin(), all.end(),
                            [&](Wall wall) { return isKnown(std::set<Wall>{wall}); }))
            return {all};
        std::vector<std::set<Wall>> each;
        each.reserve(all.size());
        for (const Wall wall : all)
            each.push_back({wall});
        return each;
    }

    [[nodiscard]] std::vector<WallLength> fittingLengths(int circle,
                                                         const std::set<Wall> &walls) const
    {
        std::vector<WallLength> fitting = wallLengths();
        std::erase_if(fitting,
                      [&](const WallLength &reach) { return !fitsAll(reach, circle, walls); });
        return fitting;
    }

    /// Whether a circle turns there at these walls.
    [[nodiscard]] bool fitsAll(const WallLength &reach, int circle,
                               const std::set<Wall> &walls) const
    {
        const auto fits = [&](const WallHit &hit) {
            if (hit.circle != circle || !hit.isAnswered() || !walls.contains(hit.wall))
                return true;
            // Who is held at the rim has not come to where it would be turned.
            const double distance = reach.distance(hit);
            return hit.held && hit.fits(hit.radius) ? distance < hit.reached : hit.fits(distance);
        };
        return std::all_of(m_own.hits.begin(), m_own.hits.end(), fits)
               && std::all_of(m_own.alike.begin(), m_own.alike.end(), fits);
    }

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
        std::set<double> radii;
        double nearest = 0.0;
        double farthest = std::numeric_limits<double>::infinity();
        for (const auto *hits : {&m_own.hits, &m_own.alike}) {
            for (const WallHit &hit : *hits) {
                if (hit.circle != circle || !walls.contains(hit.wall) || !hit.isAnswered())
                    continue;
                radii.insert(hit.radius);
                nearest = std::max(nearest, hit.reached);
                farthest = std::min(farthest, hit.before + hit.travel);
            }
        }
        if (radii.size() < 2 || nearest > farthest)
            return std::nullopt;
        return std::pair(
            WallText::tr("At the %walls a number stands for the radius of %who"),
            WallText::tr("Circle %1 turned when its centre was between %2 and %3 m from the wall, "
                         "with the radius %4 m as with %5 m. Take the radius that the circle has.")
                .arg(QString::number(circle + 1), brief(nearest), brief(farthest),
                     brief(*radii.begin()), brief(*radii.rbegin())));
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
        std::vector<const WallHit *> far;
        for (const WallHit &hit : m_own.far) {
            const Vec2 v = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body.velocity;
            const double second = dot(v, outwardNormal(hit.wall)) * 1.0; // m in 1 s
            if (hit.circle != circle)
                continue;
            if (!hit.turned || hit.step == 1 || !hit.fits(hit.radius + second))
                return std::nullopt;
            far.push_back(&hit);
        }
        if (far.size() < 2)
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

    /// Whether a hit turned the part into the wall round and left the other as large as it was.
    [[nodiscard]] static bool isMirrored(const WallHit &hit)
    {
        const Vec2 n = outwardNormal(hit.wall);
        const double along = dot(hit.came, perpendicular(n));
        return dot(hit.came, n) > 0.0 && dot(hit.left, n) < 0.0
               && std::abs(std::abs(dot(hit.left, perpendicular(n))) - std::abs(along)) < 1e-6;
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
