// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

namespace cradle {

/// The lab as if it had only the step in the folder \p step: who judges that step need not read
/// the others. All of it, if lab.json lists no such folder.
[[nodiscard]] LabFiles stepAlone(const LabFiles &files, const QString &step);

/// Folders that have a task.json and that lab.json does not list: no steps of the lab.
[[nodiscard]] QStringList unlistedSteps(const LabFiles &files);

/// SHA-256 over names and contents of all files, in order of their names; in hexadecimal.
[[nodiscard]] QString hashOf(const LabFiles &files);

} // namespace cradle
