// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"

namespace cradle {

/// What a check in Lua said of a run.
struct ScriptVerdict {
    bool passed = false;
    QString message{};                ///< what is wrong, for the student
    std::optional<double> time{};     ///< where, s from the start
    std::optional<double> expected{}; ///< in \c unit
    std::optional<double> observed{}; ///< in \c unit
    QString unit{};
    std::optional<ProgramError> error{}; ///< of the check itself; it says nothing then
};

/// Runs `check(run)` of the Lua program \p source on \p observation, in the sandbox and within the
/// limits of one step of a student's program. `run` has
///     duration, timestep (s), gravity (a vector), restitution, square, step_count, circle_count
///     language       in which the message should be, such as "en" or "de"
///     run:at(t)      the state at t s, on the straight line between the two steps around it
///     run:step(k)    the state after k steps
///     run:steps()    for state in run:steps() do … end, from the start to the end
///     run:circle(i)  one circle: run:circle(1):at(t)
///     run:hits()     a list of { time, step, kind, a, b, normal, impulse }
/// A state has time, step and circles; a circle position, velocity, radius, density, index. The
/// function returns true, or false, a message and, if it likes, { time, expected, observed, unit }.
[[nodiscard]] ScriptVerdict runCheckScript(const QString &source, const Observation &observation,
                                           const QString &language = QStringLiteral("en"));

/// What is wrong with the text of a check, without a run: its grammar, and that there is a
/// function check.
[[nodiscard]] std::optional<ProgramError> findCheckScriptError(const QString &source);

} // namespace cradle
