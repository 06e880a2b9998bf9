// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/condition_comparison.h"

namespace cradle {

void ConditionComparison::add(Aspect aspect, const Said &what, const Condition &condition,
                              const std::vector<int> &circles, const Moment &place)
{
    const bool isOfPlace = condition.isOfPlace();
    QString message = what.headline + QLatin1String("\n\n") + what.seen + QLatin1Char(' ')
                      + what.told + QLatin1Char(' ')
                      + ConditionText::tr("Look at what your program asks there, and at what it "
                                          "keeps from one step to the next.");
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
