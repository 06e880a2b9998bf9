// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <functional>

namespace cradle {

/// A right program may be off by as much again as the reference is: by a stated value that was
/// rounded, or in another right order of the same operations.
inline constexpr double toleranceMargin = 2.0;

/// A check whose tolerance the reference solution itself nearly uses up.
struct TightTolerance {
    double allowed = 0.0; ///< the tolerance of the check
    double needed = 0.0;  ///< the least with which the solution passes
    QString unit{};       ///< of both
    QString variant{};    ///< the scene where it shows
};

/// Whether the solution of \p task needs more than 1/toleranceMargin of the tolerance of \p check
/// in the scenes of seed 1. \param stop  asked before every scene; if it answers true, nothing more
/// is judged \return nullopt if it does not, if the kind has no tolerance or if the solution fails
/// anyway
[[nodiscard]] std::optional<TightTolerance>
findTightTolerance(const Task &task, const CheckSpec &check, const std::function<bool()> &stop);

} // namespace cradle
