// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/ran_lines.h"

#include <functional>

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
    int last = 0;       ///< the line that last changed what is wrong
    bool isHit = false; ///< of a wall or another circle: it may come a step later
    /// How far a changed program no longer deviates so; asked of few.
    std::function<Mending(const QString &)> mending;
};

/// The line in which one small change mends the program, proven by doing it: all of the fault, or
/// what of it shows at the moment, where one line for each wall or circle is wrong; 0 if there is
/// none among some hundred.
[[nodiscard]] int lineAtFault(const FaultQuery &query);

} // namespace cradle
