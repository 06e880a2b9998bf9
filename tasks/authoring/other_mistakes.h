// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"

namespace cradle {

/// A mistake of another step that can be made in this one, too.
struct OtherMistake {
    QString step;
    QString name;
    QString headline; ///< of its diagnosis, in the lab's own language
    QString program;  ///< this step's solution with that mistake

    friend bool operator==(const OtherMistake &, const OtherMistake &) = default;
};

/// The mistakes of other steps whose difference from their solution applies to that of \p step and
/// that are not among its own; those of the nearest step before first. One of a name and one of a
/// program are enough.
[[nodiscard]] std::vector<OtherMistake> mistakesOfOtherSteps(const LabFiles &files,
                                                             const QString &step);

/// Takes \p mistake over, with its texts in other languages.
[[nodiscard]] Result<LabFiles> withOtherMistake(const LabFiles &files, const QString &step,
                                                const OtherMistake &mistake);

} // namespace cradle
