// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/response_law_words.h"

#include <algorithm>

namespace cradle {

namespace {

/// Whether it came as it was thrown, so that it touched when it should.
bool isAsThrown(const PairHit &hit)
{
    const PairVelocities in = hit.cameParts();
    const PairVelocities &thrown = hit.meeting.velocities;
    return isAlike(in.along1, thrown.along1) && isAlike(in.along2, thrown.along2);
}

} // namespace

std::optional<LawDeviation> missedInStep(const MeasuredPair &own, const MeasuredPair &right)
{
    if (own.inSteps.size() != 3 || right.inSteps.size() != 3)
        return std::nullopt;
    const auto isAnswered = [](const PairHit &hit) { return hit.isInTime() && isAsThrown(hit); };
    const PairHit &early = own.inSteps[0];
    const PairHit &late = own.inSteps[1];
    const bool isRight = isAnswered(right.inSteps[0]) && isAnswered(right.inSteps[1]);
    const auto isMissed = [](const PairHit &hit) {
        return !hit.answered && !hit.isHeld() && !hit.stopped;
    };
    const bool isEarly = isAnswered(early) && isMissed(late);
    const bool isLate = isAnswered(late) && isMissed(early);
    if (!isRight || (!isEarly && !isLate))
        return std::nullopt;
    // Where it is missed no line runs that could be marked.
    const PairHit &answered = isEarly ? early : late;
    const QString seen =
        isEarly ? ContactText::tr("Where their rims touched after a quarter of a step of %1 s, "
                                  "they were answered; where after two thirds, they ran into each "
                                  "other.")
                : ContactText::tr("Where their rims touched after two thirds of a step of %1 s, "
                                  "they were answered; where after a quarter, they ran into each "
                                  "other.");
    return LawDeviation{
        .aspect = Aspect::Contact,
        .message =
            ContactText::tr("Whether a hit is answered depends on where in a step they touch")
            + QStringLiteral("\n\n") + cameTogether(early, !own.rebounds.empty()) + QLatin1Char(' ')
            + seen.arg(briefTimestep(early.stage.preset.timestep)) + QLatin1Char(' ')
            + ContactText::tr("Look at how the moment of the hit is worked out, and at what is "
                              "done with circles that overlap already."),
        .moment = {.stage = answered.stage, .step = answered.step, .circles = {0, 1}},
        .suspect = Suspect::Question,
        .isConditional = true};
}

} // namespace cradle
