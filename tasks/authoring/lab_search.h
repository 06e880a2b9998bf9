// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

namespace cradle {

// Finding and replacing in all that an author writes: instructions, titles, hints, questions and
// the texts of other languages, programs, mistakes, checks in Lua, expressions.

/// What is looked for.
struct LabSearch {
    QString text; ///< nothing is found if it is empty
    bool matchCase = false;
    bool wholeWords = false; ///< no letter, digit or underscore beside it
    QString step{};          ///< only in the files of this step; empty: in all

    friend bool operator==(const LabSearch &, const LabSearch &) = default;
};

/// A line of a text, or a text of a JSON file, in which it was found.
struct LabHit {
    QString path;
    int line = 0;      ///< from 1; 0 in JSON that is not broken
    QString pointer{}; ///< there: "/checks/0/title"
    QString text{};    ///< the line, or the text
    int at = 0;        ///< where it stands there first
    int count = 1;     ///< how often it stands there
};

/// In order of the files. Of a program that is kept as its difference from the solution only what
/// differs is looked at.
[[nodiscard]] std::vector<LabHit> findInLab(const LabFiles &files, const LabSearch &search);

/// Puts \p replacement in all these places. Differences are made anew, so that they still apply to
/// a solution that was changed with them; names, ids, keys and numbers of JSON stay.
/// \return an error about a file that would not be right then, as by a title that is too long, or
///     that is broken and has it
[[nodiscard]] Result<LabFiles> replacedInLab(const LabFiles &files, const LabSearch &search,
                                             const QString &replacement);

} // namespace cradle
