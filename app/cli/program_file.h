// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/result.h"

namespace cradle::cli {

/// Reads a student's program. A file that is missing, too large or no UTF-8 text is an error with
/// the file and, where there is one, the line.
Result<QString> readProgram(const QString &path);

} // namespace cradle::cli
