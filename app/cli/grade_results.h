// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/grade_progress.h"
#include "app/cli/grade_request.h"

namespace cradle::cli {

/// How the lab that was judged by is kept with the results.
inline constexpr char keptLab[] = "/lab.cradle";

/// Removes what there is of students who are not among \p ids, also from \p manifest.
void removeOthers(const QString &results, Manifest &manifest, const QStringList &ids);

/// Writes pages, gradebooks and what else follows from the students' results.
[[nodiscard]] std::optional<Error> writeResults(const GradeRequest &request, const Lab &lab,
                                                const Manifest &manifest, GradeProgress &progress);

/// What the exit status says of a class.
[[nodiscard]] ExitCode verdictOn(const Manifest &manifest, const GradeRequest &request);

} // namespace cradle::cli
