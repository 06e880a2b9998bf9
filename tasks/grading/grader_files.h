// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_results.h"

namespace cradle {

// All steps of a student in the formats of other graders; each is empty where it could not be
// true: Gradescope and GitHub know no step without a verdict.

/// Gradescope's results.json, a test for each check, the steps in order.
[[nodiscard]] QByteArray gradescopeFile(const StudentResult &student, const Lab &lab,
                                        const ClassFacts &facts);
/// What GitHub Classroom's autograding reporter reads.
[[nodiscard]] QByteArray gitHubFile(const StudentResult &student, const Lab &lab);
/// A test suite for each step; valid by the schema junit-10. A step without a verdict is skipped.
[[nodiscard]] QByteArray junitFile(const StudentResult &student, const Lab &lab);
/// A test for each check of all steps.
[[nodiscard]] QByteArray tapFile(const StudentResult &student, const Lab &lab);
/// Exercism's results.json (version 3) of one step; empty if there is no report.
[[nodiscard]] QByteArray exercismFile(const StepResult &step, const Task &task);

/// Writes them below \p folder: gradescope/ID.json, github/ID.json, junit/ID.xml, tap/ID.tap and
/// exercism/ID/STEP.json.
[[nodiscard]] std::optional<Error> writeGraderFiles(const QString &folder,
                                                    const StudentResult &student, const Lab &lab,
                                                    const ClassFacts &facts);

} // namespace cradle
