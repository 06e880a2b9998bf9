// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/hit_at_moment.h"
#include "tasks/judging/ran_lines.h"

#include <functional>
#include <optional>
#include <vector>

namespace cradle {

/// The line of a `local gravity = …` or `local restitution = …`, which makes another variable of
/// the same name instead of setting that of the world. \return 0 if there is none
[[nodiscard]] int hidingLine(const QString &program, Assignment::Field field);

/// The assignment that last changed what is wrong.
struct LastAssignment {
    int line = 0; ///< 0 if unknown
    /// If it only writes a value down: the line in which that was worked out, 0 if it is not one.
    std::optional<int> origin{};
    std::vector<int> calls{}; ///< the lines that called it, the innermost last
    /// Of a hit of two: what it makes of them.
    std::function<HitAtMoment()> hit{};
    /// Whether all that a line gives is known to be right.
    std::function<bool(int)> isSound = [](int) { return false; };
    /// Whether other circles move as they should.
    bool isOfOne = true;
};

/// Where a teacher would point first, if no change is proven to mend a program: among the lines
/// that run at the moment and not in free flight, the question before them where something is
/// answered at a wrong place, the formula where the answer is wrong; the line that works out a mass
/// where masses are.
/// \param ran   the lines that run at the moment
/// \return the last assignment if there is no better one, 0 if the fault is that a line is missing
[[nodiscard]] int guessedLine(const QString &program, const LawDeviation &deviation,
                              const RanLines &ran, const LastAssignment &last);

} // namespace cradle
