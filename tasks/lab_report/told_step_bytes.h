// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/lab_report.h"

namespace cradle {

// A told step on its way from the process that ran the student's program.

[[nodiscard]] QByteArray bytesOf(const ToldStep &told);
/// Reads it without trust. \return nothing if \p bytes are none, or a drawing is more than one
[[nodiscard]] std::optional<ToldStep> toldStepFrom(const QByteArray &bytes);

/// Whether \p svg is empty or a drawing that loads and runs nothing: of the elements and attributes
/// that an SvgPicture is made of.
[[nodiscard]] bool isPlainDrawing(const QByteArray &svg);

} // namespace cradle
