// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/subcommand.h"
#include "tasks/grading/class_journal.h"

#include <variant>

namespace cradle::cli {

/// What cradle-cli grade is asked for.
struct GradeRequest {
    QString submissions{};
    QStringList merged{}; ///< folders of results to put together; then nothing is judged
    QString labPath{};    ///< empty: the shipped one, or that of the results
    QString results{};
    QString secretPath{};
    QString rosterPath{};
    QString language{}; ///< of pages and verdicts; empty: English, or that of the merged results
    LateRule late{};
    int jobs = 1;
    Shard shard{};
    bool requireIsolation = false;
    bool dryRun = false;
    bool events = false; ///< --format json
    bool again = false;
    bool exitZero = false;
};

/// Understands the arguments; on a fault says so.
/// \return what to exit with if there is nothing to do
std::variant<GradeRequest, ExitCode> parseGradeRequest(const QStringList &arguments);

} // namespace cradle::cli
