// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"

#include <functional>

namespace cradle {

/// What a search for the line at fault needs to know.
struct FaultQuery {
    const QString &program;
    const QString &reference; ///< what it does at the moment is what should be done
    const Moment &moment;     ///< where it shows
    /// Whether a changed program no longer deviates so; asked of few.
    std::function<bool(const QString &)> isMended;
};

/// The line in which one small change mends the program, proven by doing it; 0 if there is none
/// among some hundred.
[[nodiscard]] int lineAtFault(const FaultQuery &query);

} // namespace cradle
