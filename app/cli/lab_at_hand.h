// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/lab_files/lab_files.h"

namespace cradle::cli {

/// A lab with the files that it was read from, for processes that are to have the same.
struct LabAtHand {
    QString folder{};
    QString language{}; ///< that was asked for
    LabFiles files{};
    Lab lab{};
};

/// Reads the lab in a folder, a resource or an archive, with texts in \p language where it has
/// them; tells on standard error what of it could not be read.
/// \param step  if it is given, that step alone is read, if it can be found
Result<LabAtHand> readLabAtHand(const QString &path, const QString &language = QStringLiteral("en"),
                                const QString &step = {});

/// Why the lab has no step \p id: it cannot be read, or there is none.
[[nodiscard]] QString noStep(const Lab &lab, const QString &id);

} // namespace cradle::cli
