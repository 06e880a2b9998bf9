// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"

#include <optional>

namespace cradle {

/// That a program moves the circles where the step leaves them to the laws of the scene, or does
/// not where it asks for that; nothing if all is as the step has it.
/// \param byProgram  whether the program moves them
[[nodiscard]] std::optional<CheckOutcome> moverBreach(const Task &task, bool byProgram);

/// That something is changed which the step fixes.
[[nodiscard]] std::optional<CheckOutcome> lockBreach(const Task &task, const Preset &submitted);

} // namespace cradle
