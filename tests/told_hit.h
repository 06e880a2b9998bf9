// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/pair_words.h"

#include "tests/told_numbers.h"

namespace cradle::told {

/// Step 16, where radii, densities and e are varied, and what is found of hits in it.
class ToldHit : public LabTest
{
protected:
    [[nodiscard]] std::vector<LawDeviation> foundOfHit(const programs::HitLaw &law) const
    {
        using namespace programs;
        return found(
            written({.walls = wallsOf(wallWays[1], "c.radius", "1"), .hit = hitOf(hitWays[1], law)},
                    structures[1]));
    }
    [[nodiscard]] std::vector<LawDeviation> found(const QString &program) const
    {
        const programs::LawBench bench(task(QStringLiteral("L42T16")));
        const MeasuredLaws own(&program, bench.ground);
        auto all = contactDeviations(own.pair(), bench.right.pair(), bench.ground);
        for (LawDeviation &each : responseDeviations(own.pair(), bench.right.pair(), bench.ground))
            all.push_back(std::move(each));
        return all;
    }
};

} // namespace cradle::told
