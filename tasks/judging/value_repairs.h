// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/repairs.h"

#include <set>

namespace cradle {

/// What becomes of a value.
enum class ValueChange {
    Completed, ///< it gets what it lacks: gravity, a density, a wall that is asked for
    Replaced,  ///< by what the aspect needs: a normal, a distance, the place where a wall turns
};

/// Those of \p lines in which all that is given is right up to \p moment.
[[nodiscard]] std::set<int> soundLines(const QString &source, const std::vector<int> &lines,
                                       Aspect aspect, Suspect suspect, const Moment &moment);

/// Programs that differ from \p source in one whole value that a line gives, returns or hands on.
/// What is right up to \p moment is left as it is.
/// \param lines  in which something may be changed; they are tried as they stand in the program, of
///               masses from the last
/// \param now  the lines that run at the moment
[[nodiscard]] std::vector<Repair> valueRepairsOf(const QString &source,
                                                 const std::vector<int> &lines, Aspect aspect,
                                                 Suspect suspect, const Moment &moment,
                                                 const std::set<int> &now, ValueChange change);

} // namespace cradle
