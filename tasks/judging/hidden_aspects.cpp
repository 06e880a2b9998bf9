// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/hidden_aspects.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct HiddenText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

} // namespace

bool hidesHits(const ConditionedAspect &motion)
{
    return std::any_of(motion.deviations.begin(), motion.deviations.end(),
                       [](const LawDeviation &each) { return each.hidesHits; });
}

bool hidesWalls(const ConditionedAspect &motion)
{
    return std::any_of(motion.deviations.begin(), motion.deviations.end(),
                       [](const LawDeviation &each) { return each.hidesWalls; });
}

bool isMotionWrong(const ConditionedAspect &motion)
{
    return std::any_of(motion.deviations.begin(), motion.deviations.end(),
                       [](const LawDeviation &each) { return !each.isMethod; });
}

QString unseenText(const ConditionedAspect &motion, const MeasuredLaws &own,
                   const MeasuredLaws &right, const Ground &ground,
                   const StepDeviations &deviations)
{
    // A failed check asks for walls, and at none is a circle known to come to them.
    const bool walls = deviations.isAsked(Aspect::Walls) && !right.walls().judged.empty()
                       && (motion.isOfPlace || hidesWalls(motion) || own.walls().judged.empty());
    const auto isMet = [](const PairHit &hit) { return hit.isMet(); };
    const bool hits =
        ground.pair.asked && !own.pair().isJudged
        && std::any_of(right.pair().contacts.begin(), right.pair().contacts.end(), isMet);
    if (walls && hits)
        return HiddenText::tr("Until this is right, no more can be said of walls and hits.");
    if (walls)
        return HiddenText::tr("Until this is right, no more can be said of the walls.");
    return hits ? HiddenText::tr(
               "Until this is right, no more can be said of the hits of the two circles.")
                : QString();
}

} // namespace cradle
