// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QString>

namespace cradle {

// A program that the lab knows, kept as its difference from the solution: NAME.diff. First what the
// student reads, in CommonMark and without the dashes of a comment; then the two lines of names and
// the hunks of a unified diff. The whole program is that text as its first comment, an empty line,
// and the solution with the difference.

/// The whole program. \return an Error with the line of \p diff, from 1, that does not apply to the
/// solution any more, or that is no line of a difference
[[nodiscard]] Result<QString> programFromDiff(const QString &diff, const QString &solution);

/// What programFromDiff() makes \p program of, but for blanks at the ends of its first comment and
/// of the empty lines after it. \param file  of the program, "mistakes/NAME.lua"
[[nodiscard]] QString diffOfProgram(const QString &program, const QString &solution,
                                    const QString &file);

/// "mistakes/NAME.diff" for "mistakes/NAME.lua".
[[nodiscard]] inline QString diffPathOf(const QString &path)
{
    return path.chopped(4) + QStringLiteral(".diff");
}

/// \p program with the comment that \p solution begins with after its own, where that is missing:
/// it is no mistake to leave it out, and so no difference to keep.
[[nodiscard]] QString withCommentOf(const QString &solution, const QString &program);

/// Whether the difference takes fewer lines than the program.
[[nodiscard]] bool isWorthADiff(const QString &program, const QString &solution);

/// The program after its first comment and the empty line that follows it.
[[nodiscard]] QString withoutFirstComment(const QString &program);

/// The comment block that a program begins with, without the dashes: CommonMark.
[[nodiscard]] QString firstCommentBlock(const QString &source);

} // namespace cradle
