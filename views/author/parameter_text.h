// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/checks/check_kinds.h"

namespace cradle {

/// A parameter's value as an author reads and types it: numbers with a point, vectors and ranges
/// as "2, 0", lists as "0.5, 1", lists of vectors as "2, 0; 0, 0". Empty if it is left out.
[[nodiscard]] QString textOfParameter(const ParameterInfo &info, const QJsonValue &value);

/// The value that \p text stands for; undefined if it is empty. Expressions without spaces,
/// as 1/60, are numbers, too; {{k}} is kept for the values of the lab.
/// \return an error that says what would be right
[[nodiscard]] Result<QJsonValue> parameterFromText(const ParameterInfo &info, const QString &text);

} // namespace cradle
