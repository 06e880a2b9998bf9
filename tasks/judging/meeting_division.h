// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_pair.h"

#include <QString>

#include <optional>

namespace cradle {

/// What those meetings have in common that come out right, and no others; or those that do not.
struct MeetingDivision {
    enum class Kind {
        Side,   ///< on which side of circle 1 the other is
        Coming, ///< who comes nearer, along the line of centres
        Way,    ///< where to they move, in x and y
        Size,   ///< or masses
        Speed,
        Place, ///< where in the square they meet
    };
    Kind kind = Kind::Side;
    QString phrase{};           ///< "those where circle 1 moves to the right, no others"
    bool isOfDirection = false; ///< others are answered, but not along the line of centres
};

/// A meeting, and whether it came out right.
struct JudgedMeeting {
    const PairHit *hit = nullptr;
    bool isRight = false;
};

/// \return nothing where all or none come out right, nothing that is known divides them, or several
///         things do, of which none is known to be the one that counts
[[nodiscard]] std::optional<MeetingDivision> divisionBy(const std::vector<JudgedMeeting> &meetings);

/// By whether they are answered when they come, or, if all are, along the line of centres.
/// \param hits      of many kinds
/// \param isAlong   whether all should be answered along the line of centres
[[nodiscard]] std::optional<MeetingDivision> divisionOf(const std::vector<PairHit> &hits,
                                                        bool isAlong);

} // namespace cradle
