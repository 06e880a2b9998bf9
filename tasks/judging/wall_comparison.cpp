// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"
#include "tasks/text/spoken_locale.h"

#include <algorithm>
#include <cmath>

namespace cradle {

LawDeviation WallComparison::deviation(const QString &headline, const QString &body,
                                       const WallHit &hit, const Whose &whose, Suspect suspect,
                                       bool isPosition) const
{
    QString message = headline + QStringLiteral("\n\n") + body;
    message.replace(QLatin1String("%who"), circleNames(whose.circles, m_ground.flights.size()));
    message.replace(QLatin1String("%walls"), namesOf(whose.walls));
    return {.aspect = Aspect::Walls,
            .message = message,
            .moment = {hit.stage, std::max<qint64>(hit.step, 1), {hit.circle}, isPosition},
            .suspect = suspect,
            .family = headline}; // at fewer walls it is still the same
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
    return hit.turned && fall != Vec2{}
           && (length(hit.left - turned(hit.was + fall)) < slack
               || length(hit.left - turned(hit.was) - fall) < slack);
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
