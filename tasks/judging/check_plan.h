// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/runs/variant.h"

namespace cradle {

/// A check with the scenes that it runs, or the reason why it can run none.
struct CheckPlan {
    const CheckSpec *check = nullptr;
    std::vector<Variant> variants{};
    std::vector<Variant> causes{}; ///< of circles that part inside each other: the hits that must
                                   ///< leave some so, or else the variants say nothing
    QString missing{};
};

/// Refuses what a check cannot run, or not in time.
/// \param locked  what a program must leave as it is; see locks.h
[[nodiscard]] CheckPlan planOf(const CheckSpec &check, const Preset &submission,
                               const QStringList &locked, qint64 seed);

/// What is to be said of \p plan before any of its scenes has run.
[[nodiscard]] CheckOutcome outcomeOf(const CheckPlan &plan);

} // namespace cradle
