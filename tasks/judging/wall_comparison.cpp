// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"
#include "tasks/text/spoken_locale.h"

#include <algorithm>

namespace cradle {

LawDeviation WallComparison::deviation(const QString &headline, const QString &body,
                                       const WallHit &hit, const std::vector<int> &circles,
                                       Suspect suspect, bool isPosition) const
{
    const QString names = circleNames(circles, m_ground.flights.size());
    QString message = headline + QStringLiteral("\n\n") + body;
    message.replace(QLatin1String("%who"), names);
    return {Aspect::Walls,
            message,
            {hit.stage, std::max<qint64>(hit.step, 1), {hit.circle}, isPosition},
            suspect};
}

QString WallComparison::namesOf(const std::set<Wall> &walls)
{
    QStringList names;
    for (const Wall wall : walls)
        names.append(motion::wallName(wall));
    return spokenList(names);
}

QString WallComparison::inBrackets(const std::set<Wall> &walls)
{
    return WallText::tr(" (%1)", "walls").arg(namesOf(walls));
}

} // namespace cradle
