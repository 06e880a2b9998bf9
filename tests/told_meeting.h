// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/pair_words.h"

#include "tests/told_numbers.h"

namespace cradle::told {

/// What is told of how the circles of a program meet, in a step of the shipped lab.
class ToldMeeting : public LabTest
{
protected:
    /// What is said in \p step of a program with that hit, below \p headline.
    [[nodiscard]] QString body(const char *step, const programs::HitLaw &law,
                               const QString &headline, const QString &start = {},
                               std::size_t structure = 0) const
    {
        using namespace programs;
        const LawBench bench(task(QLatin1String(step)));
        const QString program = written({.start = start,
                                         .walls = wallsOf(wallWays[1], "c.radius", "1"),
                                         .hit = hitOf(hitWays[0], law)},
                                        structures[structure]);
        const MeasuredLaws own(&program, bench.ground);
        const QString contact =
            bodyOf(contactDeviations(own.pair(), bench.right.pair(), bench.ground), headline);
        return contact.isEmpty() ? bodyOf(
                   responseDeviations(own.pair(), bench.right.pair(), bench.ground), headline)
                                 : contact;
    }
};

} // namespace cradle::told
