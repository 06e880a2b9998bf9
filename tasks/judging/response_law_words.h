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

/// That in a second hit something counts that was kept from the first.
[[nodiscard]] std::optional<LawDeviation> laterDeviation(const MeasuredPair &own,
                                                         const MeasuredPair &right);
/// That what a program takes for e before its first hit is not what it takes after.
[[nodiscard]] LawDeviation lateRestitution(const MeasuredPair &own);
/// That slow circles are answered in another way than fast ones.
[[nodiscard]] std::optional<LawDeviation> slowDeviation(const MeasuredPair &own,
                                                        const MeasuredPair &right);
/// That the hit of the own scene is not answered as those of other scenes are.
/// \param isElseRight  nothing else is wrong
[[nodiscard]] std::optional<LawDeviation> ownDeviation(const MeasuredPair &own, bool isElseRight);

} // namespace cradle
