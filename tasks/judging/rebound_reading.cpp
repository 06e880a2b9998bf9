// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_reading.h"

namespace cradle {

Rebound reboundOf(const PairHit &hit, double heavy)
{
    if (!hit.isMet())
        return {.e = hit.meeting.restitution, .first = -1.0, .second = -1.0};
    const PairVelocities in = hit.cameParts();
    const PairVelocities out = hit.leftParts();
    const double u = in.along1 - in.along2;
    return {.e = hit.meeting.restitution,
            .first = (1.0 + heavy) / heavy * (in.along1 - out.along1) / u - 1.0,
            .second = (1.0 + heavy) * (out.along2 - in.along2) / u - 1.0,
            .across1 = out.across1 / in.across1,
            .across2 = out.across2 / in.across2,
            .sum = (out.along1 + out.along2) / (in.along1 + in.along2)};
}

} // namespace cradle
