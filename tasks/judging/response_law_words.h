// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/response_laws.h"

#include <optional>

namespace cradle {

/// How equal circles answer hits without losses.
struct EqualReading {
    bool isRight = true;                ///< as they should
    std::optional<LawDeviation> said{}; ///< what is wrong, if it is to be said
    std::optional<ResponseLaw> law{};   ///< that they follow, if it is a known wrong one
};

/// \param isExplained  what e does explains what is wrong
[[nodiscard]] EqualReading equalReading(const MeasuredPair &own, const MeasuredPair &right,
                                        bool isExplained);

/// What the new part along the line of centres of one circle, from 0, is made of: so much of that
/// of circle 1 before the hit, and so much of that of circle 2. Begins with a blank; empty if it is
/// not the same in all \p hits.
[[nodiscard]] QString lawOfPart(const std::vector<EqualHit> &hits, int circle);

/// That what circles have after \p hits, or along the line of centres, does not depend on what they
/// came with; shown at \p hit.
[[nodiscard]] std::optional<LawDeviation>
constantDeviation(const MeasuredPair &own, const std::vector<EqualHit> &hits, const PairHit &hit);

/// That with some e no velocity changes, and with all others below 1 it comes out right.
[[nodiscard]] std::optional<LawDeviation> unansweredRebound(const MeasuredPair &own,
                                                            const MeasuredPair &right);

/// An equal and opposite push along the line of centres that has a wrong length.
struct SizeOfPush {
    QString headline{};
    QString seen{};         ///< on what it depends; begins with a blank
    bool isOfEveryE = true; ///< of those that were tried
    bool isRounded = false; ///< to whole numbers
};
/// A factor is told only if circles of another size, and in a longer step, follow it, too.
[[nodiscard]] SizeOfPush sizeOfPush(const MeasuredPair &own, const MeasuredPair &right,
                                    const PairHit &hit, const PairHit &good);

/// That in a second hit something counts that was kept from the first.
[[nodiscard]] std::optional<LawDeviation> laterDeviation(const MeasuredPair &own,
                                                         const MeasuredPair &right);
/// That \p wrong is pushed along the line of \p first, the first hit of its run.
[[nodiscard]] LawDeviation keptLineDeviation(const PairHit &first, const PairHit &wrong);
/// That what a program takes for e before its first hit is not what it takes after.
[[nodiscard]] LawDeviation lateRestitution(const MeasuredPair &own);
/// That slow circles are answered in another way than fast ones.
[[nodiscard]] std::optional<LawDeviation> slowDeviation(const MeasuredPair &own,
                                                        const MeasuredPair &right);
/// That what a hit does depends on when the rims touch in a step, or on the timestep.
/// \param isElseRight  in very short steps hits come out right
[[nodiscard]] std::optional<LawDeviation>
steppedDeviation(const MeasuredPair &own, const MeasuredPair &right, bool isElseRight);
/// That the push of a hit goes on over several steps, and is not right after the first.
[[nodiscard]] std::optional<LawDeviation> spreadDeviation(const MeasuredPair &own,
                                                          const MeasuredPair &right);
/// How \p hit came, head-on, and with which e where that counts.
[[nodiscard]] QString cameTogether(const PairHit &hit, bool isOfE);
/// What both had along the line of centres after \p hit; enough digits to tell \p other from it.
[[nodiscard]] QString leftBeside(const PairHit &hit, const PairHit &other);
/// That the push has another size in steps of the usual length than in very short ones, by a normal
/// that is shorter the deeper they overlap.
[[nodiscard]] std::optional<LawDeviation> overlapDeviation(const MeasuredPair &own,
                                                           const MeasuredPair &right);
/// That the hit of the own scene is not answered as those of other scenes are.
/// \param isElseRight  nothing else is wrong
[[nodiscard]] std::optional<LawDeviation> ownDeviation(const MeasuredPair &own,
                                                       const MeasuredPair &right, bool isElseRight);

} // namespace cradle
