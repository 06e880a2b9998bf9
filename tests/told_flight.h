// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/flight_words.h"

#include "tests/told_numbers.h"

namespace cradle::told {

/// What is told of how the circles of a program move, in a step of the shipped lab.
class ToldFlight : public LabTest
{
protected:
    /// What is said in \p step of a program that adds \p place to the place and \p velocity to the
    /// velocity, below \p headline.
    [[nodiscard]] QString body(const char *step, const QString &place, const QString &velocity,
                               const char *headline = "") const
    {
        return bodyOfProgram(
            step,
            programs::written({.move = QStringLiteral("c.position = c.position + %1 "
                                                      "c.velocity = c.velocity + %2")
                                           .arg(place, velocity)},
                              programs::structures[0]),
            headline);
    }
    [[nodiscard]] QString bodyOfProgram(const char *step, const QString &program,
                                        const char *headline = "") const
    {
        const programs::LawBench bench(task(QLatin1String(step)));
        const MeasuredLaws own(&program, bench.ground);
        return bodyOf(flightDeviations(own.flight(), bench.right.flight(), bench.ground),
                      QString::fromUtf8(headline));
    }

    const QString way = QStringLiteral("c.velocity * h");
    const QString fall = QStringLiteral("gravity * h");
};

} // namespace cradle::told
