// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace cradle {

/// A line of a program that says another number than the solution does there, and else the same.
struct OtherValue {
    QString here;     ///< the line, without blanks around it and without its comment
    QString solution; ///< the same of the solution

    friend bool operator==(const OtherValue &, const OtherValue &) = default;
};

/// Where \p program, a mistake, differs from \p solution in numbers alone beside a difference of
/// another kind, which is the mistake: a value that the solution was given later, and that was not
/// followed. Empty if all differences are numbers: then they are the mistake.
[[nodiscard]] std::vector<OtherValue> otherValues(const QString &program, const QString &solution);

} // namespace cradle
