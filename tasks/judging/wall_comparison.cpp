// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"
#include "tasks/text/spoken_locale.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cradle {

LawDeviation WallComparison::deviation(const QString &headline, const QString &body,
                                       const WallHit &hit, const Whose &whose, Suspect suspect,
                                       bool isPosition) const
{
    QString message = headline + QStringLiteral("\n\n") + body;
    message.replace(QLatin1String("%who"), circleNames(whose.circles, m_ground.flights.size()));
    message.replace(QLatin1String("%walls"), namesOf(whose.walls));
    const bool isOfOne = whose.walls.size() == 1;
    return {.aspect = Aspect::Walls,
            .message = message,
            .moment = {hit.stage, std::max<qint64>(hit.step, 1), {hit.circle}, isPosition},
            .suspect = suspect,
            .family = headline, // at fewer walls it is still the same
            .wall = isOfOne ? std::optional(*whose.walls.begin()) : std::nullopt};
}

std::vector<WallComparison::Whose> WallComparison::groupsOf(const std::vector<std::size_t> &hits,
                                                            const std::vector<WallHit> &tried) const
{
    const auto isSaid = [&](int circle, Wall wall) {
        return std::any_of(hits.begin(), hits.end(), [&](std::size_t i) {
            return tried[i].circle == circle && tried[i].wall == wall;
        });
    };
    const auto isDenied = [&](int circle, const std::set<Wall> &walls) {
        return std::any_of(tried.begin(), tried.end(), [&](const WallHit &hit) {
            return hit.circle == circle && walls.contains(hit.wall) && !hit.missed
                   && !isSaid(circle, hit.wall);
        });
    };
    std::vector<Whose> groups;
    for (const int circle : m_own.judged) {
        Whose own{{circle}, {}};
        std::copy_if(std::begin(allWalls), std::end(allWalls),
                     std::inserter(own.walls, own.walls.end()),
                     [&](Wall wall) { return isSaid(circle, wall); });
        if (own.walls.empty())
            continue;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Whose &group) {
            return !isDenied(circle, group.walls)
                   && std::none_of(group.circles.begin(), group.circles.end(),
                                   [&](int other) { return isDenied(other, own.walls); });
        });
        if (same == groups.end()) {
            groups.push_back(own);
        } else {
            same->circles.push_back(circle);
            same->walls.merge(own.walls);
        }
    }
    return groups;
}

std::set<Wall> WallComparison::allOfThem() const
{
    std::set<Wall> walls;
    for (const WallHit &hit : m_right.hits) {
        if (hit.turned)
            walls.insert(hit.wall);
    }
    return walls;
}

bool WallComparison::isRightFall(const WallHit &hit) const
{
    const Vec2 fall = hit.stage.preset.timestep * hit.stage.preset.gravity;
    const double e = rebounds() ? hit.restitution : 1.0;
    const Vec2 n = outwardNormal(hit.wall);
    const auto turned = [&](Vec2 v) { return v - (1.0 + e) * dot(v, n) * n; };
    const double slack = 1e-6 * (1.0 + length(hit.was));
    if (!hit.turned || fall == Vec2{})
        return false;
    // Who parts the step at the hit falls a share of it before, and the rest after.
    const Vec2 before = turned(hit.was + fall) - hit.left;
    const Vec2 after = turned(hit.was) + fall - hit.left;
    const auto [low, high] = std::minmax({dot(before, n), dot(after, n)});
    return std::abs(cross(before, n)) < slack && low < slack && high > -slack;
}

bool WallComparison::isNear(double a, double b) const
{
    return std::abs(a - b) <= blur() * (1.0 + std::abs(b));
}

QString WallComparison::withE(const WallHit &hit) const
{
    return rebounds() ? WallText::tr("Here e is %1. ").arg(brief(hit.restitution)) : QString();
}

QString WallComparison::namesOf(const std::set<Wall> &walls) const
{
    return wallNames(walls, allOfThem());
}

QString wallNames(const std::set<Wall> &walls, const std::set<Wall> &all)
{
    if (walls.size() > 1 && std::includes(walls.begin(), walls.end(), all.begin(), all.end()))
        return WallText::tr("walls", "behind: at the");
    QStringList names;
    for (const Wall wall : walls)
        names.append(motion::wallName(wall));
    if (names.size() < 2)
        return names.join(QString());
    const QString last = names.takeLast();
    //: "left wall, floor" and "ceiling"
    return WallText::tr("%1 and %2", "walls").arg(spokenList(names), last);
}

} // namespace cradle
