// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"

#include <functional>

namespace cradle {

/// How much of a fault a change takes away.
enum class Mending { None, Part, All };

/// What a search for the line at fault needs to know.
struct FaultQuery {
    const QString &program;
    const QString &reference; ///< what it does at the moment is what should be done
    const Moment &moment;     ///< where it shows
    /// How far a changed program no longer deviates so; asked of few.
    std::function<Mending(const QString &)> mending;
};

/// The line in which one small change mends the program, proven by doing it: all of the fault, or
/// what of it shows at the moment, where one line for each wall or circle is wrong; 0 if there is
/// none among some hundred.
[[nodiscard]] int lineAtFault(const FaultQuery &query);

} // namespace cradle
