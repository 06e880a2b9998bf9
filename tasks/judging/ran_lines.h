// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"

#include <set>

namespace cradle {

/// The lines of a program that run at a moment, and in the step before it.
struct RanLines {
    std::set<int> now{};
    std::set<int> before{};

    /// Those that only the moment needs.
    [[nodiscard]] std::vector<int> special() const;
};

/// \return no lines where the program stops before the moment, or no circle shows it
[[nodiscard]] RanLines ranLines(const QString &program, const Moment &moment);

} // namespace cradle
