// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_folder.h"
#include "tasks/grading/judging_request.h"

namespace cradle {

/// What a student handed in, as bytes; none of them was understood yet.
struct HandedIn {
    JudgingRequest request{}; ///< without seed
    QString remark{};         ///< what is strange about it; plain text
};

/// Reads the files of \p student that can be work in \p lab, and no others. A .cradle-work file
/// goes before a workspace (steps/ID.lua), that before loose programs (ID.lua, or one of any name,
/// which becomes lab.lua); a workspace may lie some folders down, or in a zip. Links that lead out
/// of what the student handed in are not followed, and are told.
[[nodiscard]] HandedIn readHandedIn(const FoundStudent &student, const QByteArray &classRoot,
                                    const Lab &lab);

} // namespace cradle
