// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace cradle {

/// A line of one of two texts, or of both.
struct DiffLine {
    enum class Kind { Same, Removed, Added };

    Kind kind = Kind::Same;
    QString text{};
    int before = 0; ///< its number in the text before, from 1; 0 if it is not there
    int after = 0;  ///< its number in the text after, from 1; 0 if it is not there

    friend bool operator==(const DiffLine &, const DiffLine &) = default;
};

/// The lines of a text without their ends; what follows the last end is no line if it is empty.
[[nodiscard]] QStringList linesOf(const QString &text);

/// What makes \p after of \p before, with the fewest lines removed and added (Myers 1986, "An O(ND)
/// difference algorithm"); texts that have very little in common are told more coarsely. All lines
/// of both texts, in order.
[[nodiscard]] std::vector<DiffLine> lineDiff(const QString &before, const QString &after);

/// Some lines of a difference, with a few around them that are the same.
struct DiffHunk {
    std::vector<DiffLine> lines{};
};

/// The parts of a difference where something is changed. \param context  lines around a change
[[nodiscard]] std::vector<DiffHunk> hunksOf(const std::vector<DiffLine> &diff, int context = 3);

} // namespace cradle
