// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_laws.h"

#include "tasks/judging/deviation.h"

#include <cmath>

namespace cradle {

std::vector<FactorLaw> factorLaws()
{
    return {
        {[](double) { return 1.0; }, ReboundText::tr("e changes nothing in the hits tried")},
        {[](double e) { return e * e; }, ReboundText::tr("e is squared in the hit of two circles")},
        {[](double e) { return std::sqrt(e); },
         ReboundText::tr("The root of e is used in the hit of two circles")},
        {[](double e) { return 1.0 - e; },
         ReboundText::tr("e works the wrong way round: the factor is 2 − e, not 1 + e")},
        {[](double e) { return 2.0 * e - 1.0; },
         ReboundText::tr("The push is multiplied by 2 e instead of 1 + e")},
        {[](double e) { return e - 1.0; },
         ReboundText::tr("The push is multiplied by e instead of 1 + e")},
        {[](double e) { return e * (1.0 + e) - 1.0; },
         ReboundText::tr("The push is multiplied by e (1 + e) instead of 1 + e")},
        {[](double e) { return 1.0 / e; }, ReboundText::tr("The rebound is divided by e")},
        {[](double e) { return -e; },
         ReboundText::tr("The sign of e is wrong in the hit of two circles")}};
}

QString pushHeadline(const PushLine &push)
{
    const auto number = [](double value) { return brief(std::round(value * 100.0) / 100.0); };
    const QString perE = number(std::abs(push.perE));
    QString headline =
        push.perE > 0.0 ? ReboundText::tr("The push is multiplied by %1 + %2 e instead of 1 + e")
                        : ReboundText::tr("The push is multiplied by %1 − %2 e instead of 1 + e");
    if (perE == QLatin1String("1"))
        headline.replace(QStringLiteral("%2 e"), QStringLiteral("e"));
    else
        headline = headline.arg(QStringLiteral("%1"), perE);
    return headline.arg(number(push.without));
}

bool isTimesE(int circle, const MeasuredPair &own, const MeasuredPair &right)
{
    const auto partOf = [circle](const PairVelocities &v) {
        return circle == 0 ? v.along1 : v.along2;
    };
    bool isOfElastic = true;
    bool isOfRight = true;
    for (std::size_t i = 0; i < own.rebounds.size(); ++i) {
        const PairHit &hit = own.rebounds[i];
        const double e = hit.meeting.restitution;
        const PairVelocities in = hit.cameParts();
        const double left = partOf(hit.leftParts());
        const double elastic = circle == 0 ? in.along2 : in.along1;
        const double asked = partOf(right.rebounds[i].leftParts());
        isOfElastic = isOfElastic && std::abs(left - e * elastic) < reboundBlur;
        isOfRight = isOfRight && std::abs(left - e * asked) < reboundBlur;
    }
    return isOfElastic || isOfRight;
}

} // namespace cradle
