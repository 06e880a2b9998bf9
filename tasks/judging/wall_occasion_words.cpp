// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_occasion_words.h"

#include "tasks/judging/brief_beside.h"
#include "tasks/judging/wall_comparison.h"

namespace cradle {

namespace {

/// With which velocity it came.
Vec2 cameWith(const WallHit &hit)
{
    return hit.turned
               ? hit.came
               : hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body.velocity;
}

} // namespace

QString seenAtWall(const WallOccasion &own, const WallOccasion &right, bool isLate)
{
    const WallHit &hit = own.hit;
    QString seen =
        (isLate       ? ConditionText::tr("At %1 s of its run circle %2 came to the %3 at %4 m "
                                                "with %5 m/s and went on past it at first.")
         : hit.turned ? ConditionText::tr("At %1 s of its run circle %2 came to the %3 at %4 m "
                                          "with %5 m/s and left it with %6 m/s; %7 m/s is right.")
                      : ConditionText::tr("At %1 s of its run circle %2 came to the %3 at %4 m "
                                          "with %5 m/s and went on past it."))
            .arg(brief(own.when.time))
            .arg(hit.circle + 1)
            .arg(motion::wallName(hit.wall), brief(own.when.place), brief(cameWith(hit)));
    if (!hit.turned || isLate)
        return seen;
    const Vec2 n = outwardNormal(hit.wall);
    const Vec2 t = perpendicular(n);
    const Vec2 good =
        -right.hit.back * dot(hit.came, n) * n + right.hit.along * dot(hit.came, t) * t;
    return seen.arg(briefBeside(hit.left, good), briefBeside(good, hit.left));
}

QString rightAtWall(const Series<WallOccasion> &series, const WallHit &wrong, const QString &text)
{
    const WallOccasion *beside = nullptr;
    for (std::size_t i = 0; i < series.all.size(); ++i) {
        const WallOccasion &one = *series.all[i].own;
        if (series.when[i].isRight
            && (!beside || (one.hit.wall == wrong.wall && beside->hit.wall != wrong.wall)))
            beside = &one;
    }
    return QLatin1Char(' ')
           + text.arg(beside->hit.circle + 1)
                 .arg(brief(beside->when.time), motion::wallName(beside->hit.wall),
                      brief(beside->when.place), brief(cameWith(beside->hit)));
}

} // namespace cradle
