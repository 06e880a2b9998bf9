// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QStringList>

namespace cradle {

/// How much of a range of values some students draw.
struct TriedRange {
    QString step; ///< folder; empty: of the whole lab
    QString name;
    int count = 0; ///< of the values that can be drawn
    int tried = 0; ///< of those, by some of the students or by nobody in particular
    double least = 0.0;
    double most = 0.0; ///< of those that were tried

    friend bool operator==(const TriedRange &, const TriedRange &) = default;
};

/// The ranges of the lab and its steps, with what \p students draw of them.
[[nodiscard]] std::vector<TriedRange> triedRanges(const LabFiles &files,
                                                  const QStringList &students);

/// Numbers of students, from 1 on, who together draw every value of every range, the ends of all
/// ranges first, as far as \p most students can; at least \p least of them, whatever they draw.
/// Empty if nothing is drawn.
[[nodiscard]] QStringList studentsToTry(const LabFiles &files, int least, int most);

} // namespace cradle
