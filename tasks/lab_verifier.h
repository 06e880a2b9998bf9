// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/check_report.h"
#include "tasks/lab.h"

namespace cradle {

/// What became of one program that a step of a lab knows.
struct VerifiedProgram {
    enum class Role { Starter, Solution, Mistake, Remark };

    Role role = Role::Mistake;
    QString name;
    std::vector<CheckReport> reports{}; ///< one for each seed
};

/// A step of a lab with what its programs showed of it.
struct VerifiedTask {
    QString id;
    QString title;
    QStringList checks{}; ///< ids
    std::vector<VerifiedProgram> programs{};
    QStringList problems{}; ///< what is not as it should be, with what would be
};

/// Judges the lab itself: every starter fails by a check, not by an error; every solution passes
/// with five seeds; every mistake fails and is diagnosed as itself; every remark passes and is
/// recognised; every check is failed by a mistake. Uses all processors.
/// \param only  the id of one step; empty for all
[[nodiscard]] std::vector<VerifiedTask> verifyLab(const Lab &lab, const QString &only = {});

/// The matrix of mistakes and checks of a step, and its problems, for a terminal.
[[nodiscard]] QString describeVerified(const VerifiedTask &task);

} // namespace cradle
