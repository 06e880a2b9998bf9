// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/ran_lines.h"
#include "tasks/judging/repairs.h"

#include <functional>
#include <optional>

namespace cradle {

/// How much of a fault a change takes away, with nothing new instead.
enum class Mending { None, Part, All };

/// What a search for the line at fault needs to know.
struct FaultQuery {
    const QString &program;
    const QString &reference; ///< what it does at the moment is what should be done
    const Moment &moment;     ///< where it shows
    const RanLines &ran;      ///< what runs there
    Suspect suspect = Suspect::Answer;
    int last = 0;                   ///< the line that last changed what is wrong
    Aspect aspect = Aspect::Motion; ///< of a hit it may show a step later
    bool isAnyMethod = false;       ///< any integrator is right
    /// Whether a changed program passes all that failed; asked of some dozens.
    std::function<bool(const QString &)> passes{};
    /// How far a changed program no longer deviates so, where others go on; asked of few.
    std::function<Mending(const QString &)> mending;
};

/// One small change that mends the program, proven by making it: all of the fault, or what of it
/// shows at the moment, where one line for each wall or circle is wrong; nothing if there is none
/// among some hundred, or the WorkLimit is passed. Its line is the line at fault.
[[nodiscard]] std::optional<Repair> repairOf(const FaultQuery &query);

} // namespace cradle
