// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

namespace cradle {

/// What of a lab's texts is begun and not finished: a language in which a step lacks texts that it
/// has in the lab's own, texts of what the step has not, such as a mistake that was renamed, and
/// texts that are still those of the template of new steps; pictures that instructions name and
/// the step has not, and comments in them that begin no part. A language that the lab has no text
/// in is none of it. Errors with the file's path in the lab.
[[nodiscard]] std::vector<Error> textGaps(const LabFiles &files);

} // namespace cradle
