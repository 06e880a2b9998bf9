// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/reading/lab_source.h"
#include "tasks/text/program_diff.h"

namespace cradle {

/// Reads what a step of a lab knows of programs: starter.lua, or starter.LANGUAGE.lua with its
/// comments in that language, solution.lua, mistakes/ (whole, or as differences from the solution),
/// remarks/ and the checks in Lua. What cannot be read is named in Lab::findings.
/// \param step   the step's folder
/// \param json   the step's task.json
/// \param words  its texts in another language, where it has them
void readScripts(const LabSource &source, const QString &step, const QString &language,
                 const QJsonObject &json, const QJsonObject &words, Task &task, Lab &lab);

} // namespace cradle
