// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QDateTime>

namespace cradle {

/// What an author has changed and not saved: kept beside all labs while it is so, and found again
/// when the window was killed.
struct LabDraft {
    QString folder{}; ///< of the lab; empty: it was never saved
    QDateTime when{}; ///< UTC
    LabFiles files{}; ///< all of the lab, with the changes
    LabFiles base{};  ///< the lab on disk, with what was changed as it was before
    QString path{};   ///< of the draft's own file

    friend bool operator==(const LabDraft &, const LabDraft &) = default;
};

/// Keeps in the folder \p drafts what of \p files differs from \p onDisk, for this process.
/// \param folder  of the lab; empty if it was never saved
std::optional<Error> saveDraft(const QString &drafts, const QString &folder, const LabFiles &files,
                               const LabFiles &onDisk);

/// Removes the draft of this process.
void removeDraft(const QString &drafts, const QString &folder);

/// The newest draft of that lab that a process left which is no more.
/// \param onDisk  the lab as it is now
std::optional<LabDraft> findDraft(const QString &drafts, const QString &folder,
                                  const LabFiles &onDisk);

} // namespace cradle
