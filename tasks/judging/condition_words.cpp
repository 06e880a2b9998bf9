// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/condition_comparison.h"

namespace cradle {

QString ConditionComparison::counted(Aspect aspect, const std::vector<Occasion> &when)
{
    const auto text = [&] {
        switch (aspect) {
        case Aspect::Walls:
        case Aspect::Course:
            return ConditionText::tr("Of %1 arrivals at walls, here and there, early and late, %2 "
                                     "came out right.");
        case Aspect::Contact:
        case Aspect::Response:
            return ConditionText::tr("Of %1 hits of the two circles, here and there, early and "
                                     "late, %2 came out right.");
        case Aspect::Start:
        case Aspect::Motion:
            break;
        }
        return ConditionText::tr("Of %1 steps of free flight, here and there, early and late, %2 "
                                 "came out right.");
    }();
    return QLatin1String("\n\n") + text.arg(when.size()).arg(rightOnes(when)) + QLatin1Char(' ');
}

void ConditionComparison::add(Aspect aspect, QString message, const Condition &condition,
                              const std::vector<int> &circles, const Moment &place)
{
    const bool isOfPlace = condition.isOfPlace();
    message += QLatin1Char(' ')
               + ConditionText::tr("Look at what is asked before the lines that do it, and at what "
                                   "your program keeps from one step to the next.");
    message.replace(QLatin1String("%who"), circleNames(circles, m_ground.flights.size()));
    LawDeviation said{.aspect = aspect,
                      .message = message,
                      .moment = isOfPlace ? place : m_shown,
                      .suspect = Suspect::Question,
                      .isConditional = true};
    said.moment.circles = circles;
    m_said.deviations.insert(m_said.deviations.begin(), said);
    m_said.isOfPlace |= isOfPlace;
}

ConditionedAspect conditioned(Aspect aspect, std::vector<LawDeviation> found,
                              const MeasuredLaws &own, const MeasuredLaws &right,
                              const Ground &ground, const Moment &shown)
{
    const ConditionComparison comparison(std::move(found), own, right, ground, shown);
    switch (aspect) {
    case Aspect::Motion:
        return conditionedFlight(comparison);
    case Aspect::Walls:
        return conditionedWalls(comparison);
    case Aspect::Contact:
    case Aspect::Response:
        return conditionedPair(comparison, aspect);
    case Aspect::Start:
    case Aspect::Course:
        break;
    }
    return {};
}

} // namespace cradle
