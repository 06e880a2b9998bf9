// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

namespace cradle {

/// A lab as students may have it.
struct StudentEdition {
    LabFiles files{};
    int left = 0;              ///< how many files were left out
    QStringList unexplained{}; ///< ids of steps whose checks do not tell what law is right, so that
                               ///< nothing but they can be said of work that fails
};

/// Leaves out solutions, scenes that pass, mistakes, remarks, their texts in every language, and
/// what no step uses: notes of the teacher perhaps. lab.json names the whole lab by its hash, so
/// that what is handed in belongs to that. What checks and questions ask for stays, for they judge
/// in the student's window.
/// \return an error about a file of the lab that cannot be read
[[nodiscard]] Result<StudentEdition> studentEdition(const LabFiles &files);

} // namespace cradle
