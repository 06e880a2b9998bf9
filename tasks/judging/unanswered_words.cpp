// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_reading.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <cmath>

namespace cradle {

std::optional<LawDeviation> unansweredRebound(const MeasuredPair &own, const MeasuredPair &right)
{
    QStringList with;
    QStringList without;
    std::optional<PairHit> shown;
    for (std::size_t i = 0; i < own.rebounds.size(); ++i) {
        const PairHit &hit = own.rebounds[i];
        const QString e = brief(hit.meeting.restitution);
        if (hit.answered || hit.stopped) {
            const Rebound r = reboundOf(hit);
            if (std::abs(r.first - r.e) > reboundBlur || std::abs(r.second - r.e) > reboundBlur)
                return std::nullopt;
            with.append(e);
            continue;
        }
        without.append(e);
        if (!shown) {
            shown = hit;
            shown->step = right.rebounds[i].step;
        }
    }
    if (!shown || with.isEmpty())
        return std::nullopt;
    const QString separator = QStringLiteral(", ");
    return responseDeviation(
        ResponseText::tr("With e = %1 a hit changes no velocity").arg(without.join(separator)),
        ResponseText::tr("They came nearer with %1 m/s along the line of centres, touched, and "
                         "both kept their velocities; with e = %2 it comes out right. Look at what "
                         "is asked before the lines with the answer, and at what e does there.")
            .arg(brief(shown->slowness * shown->meeting.closing()), with.join(separator)),
        *shown, Suspect::Question);
}

} // namespace cradle
