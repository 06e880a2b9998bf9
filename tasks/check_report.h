// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/program.h"

#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// What one check found.
struct CheckOutcome {
    QString id;
    QString title;
    bool passed = false;
    QString message{};                ///< what was observed and what was expected, with units
    std::optional<double> expected{}; ///< in \c unit
    std::optional<double> observed{}; ///< in \c unit
    QString unit{};
    qint64 step = -1;  ///< where it first went wrong; −1 if it passed or nothing can be shown
    QString variant{}; ///< the scene where it first went wrong: "preset" is the student's own
    std::optional<Preset> scene{}; ///< that scene, to be shown
    bool pinned = false;           ///< that scene keeps its values whatever a program sets
    int line = 0;        ///< of the program: what moved the circle in that step; 0 if unknown
    double points = 1.0; ///< what passing it is worth

    friend bool operator==(const CheckOutcome &, const CheckOutcome &) = default;
};

/// A known mistake that explains why a submission failed.
struct Diagnosis {
    QString mistake; ///< its name in the lab
    QString message; ///< what was observed, what it means, where to look; CommonMark
    QString check{}; ///< id of the failed check where it showed

    friend bool operator==(const Diagnosis &, const Diagnosis &) = default;
};

/// A word about work that passes.
struct Remark {
    QString id;
    QString message; ///< CommonMark

    friend bool operator==(const Remark &, const Remark &) = default;
};

/// The verdict on one submission of one step.
struct CheckReport {
    QString labId;
    QString labHash; ///< sha256 of the lab's files
    QString taskId;
    qint64 seed = 1;
    bool passed = false;
    std::vector<CheckOutcome> checks{};
    std::optional<Diagnosis> diagnosis{}; ///< none if nothing known matches
    std::vector<Remark> remarks{};
    std::optional<ProgramError> error{}; ///< the program did not load or stopped
    QString commit{};                    ///< the commit message of the step; filled in as observed
    qint64 elapsedMs = 0;

    friend bool operator==(const CheckReport &, const CheckReport &) = default;
};

} // namespace cradle
