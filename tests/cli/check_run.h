// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/program_run.h"

namespace cradle::programs {

/// Words with spaces between them.
inline QStringList words(const char *line)
{
    return text(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// A file of lab 4.2.
inline QString lab(const char *file)
{
    return sourcePath("tasks/labs/lab-4.2/") + QLatin1String(file);
}

} // namespace cradle::programs
