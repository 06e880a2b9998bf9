// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_journal.h"

namespace cradle {

/// What was found in folders of results that are to be put together.
struct MergedClass {
    Manifest manifest{};                ///< of the whole class, as if one machine had judged it
    std::map<QString, QString> files{}; ///< students/ID.json to take, by id
    QStringList remarks{};              ///< doubles, shards that died, whoever is missing
    QStringList lacking{};              ///< ids of the class in none of the folders
};

/// Reads the manifests of \p folders and chooses the file of every student: of one who is there
/// more than once with the same result, that; where only one has all verdicts, that one. \return an
/// error if results are of different versions or classes, if two verdicts on one student
///     differ, or if a file is not as its manifest says
Result<MergedClass> mergeResults(const QStringList &folders);

} // namespace cradle
