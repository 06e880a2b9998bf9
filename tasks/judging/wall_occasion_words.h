// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/condition_comparison.h"

namespace cradle {

/// What was seen of a hit at a wall that does not come out right.
/// \param isLate  it was turned, but not when it came
[[nodiscard]] QString seenAtWall(const WallOccasion &own, const WallOccasion &right, bool isLate);

/// One that comes out right, at the same wall if there is one, to be looked at beside \p wrong.
/// \param text  with places for circle, time, wall, place and velocity
/// \pre one of \p series is right
[[nodiscard]] QString rightAtWall(const Series<WallOccasion> &series, const WallHit &wrong,
                                  const QString &text);

} // namespace cradle
