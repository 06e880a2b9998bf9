// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/points.h"

#include <functional>

namespace cradle {

/// Somebody of the roster who handed in nothing.
struct MissingStudent {
    QString id{}; ///< as the roster has it
    QString name{};
    QString number{};
    QString email{};
};

/// What is known of a class besides the results of its students; a plain value.
struct ClassFacts {
    QString className{};
    QString isolation{}; ///< in a few words: "rlimits, seccomp; no namespaces"
    QString program{};   ///< name and version of what judged: "Cradle 0.1.0"
    LateRule late{};
    std::vector<MissingStudent> missing{};
    bool graderFiles = true; ///< whether each student is written for other graders, too
    QStringList remarks{};   ///< what else the teacher should know; plain text
    QString language = QStringLiteral("en"); ///< of the pages: that in force
};

/// Writes everything that follows from the results in \p resultsFolder/students (ID.json, one for
/// each student, read one after another): students/ID.html, gradebook.csv and
/// gradebooks/, the folders of other graders, and class.html. The same results and facts give the
/// same bytes. Files that are there are replaced whole.
/// \param progress  after every student
/// \return what could not be read or written
[[nodiscard]] std::optional<Error>
writeClassResults(const QString &resultsFolder, const Lab &lab, const ClassFacts &facts,
                  const std::function<void(int done, int total)> &progress = {});

} // namespace cradle
