// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QMap>

namespace cradle {

/// The number that an expression comes to: numbers, the names of \p values, pi; + - * / ^ with the
/// usual precedence (^ binds to the right and before a sign), parentheses; sqrt, abs, exp, ln,
/// log10, sin, cos, tan, asin, acos, atan (radians), floor, ceil, round, min, max, atan2. At most
/// 400 characters.
/// \return an error that says what is wrong with it; also if the number is not finite
[[nodiscard]] Result<double> evaluated(const QString &text,
                                       const QMap<QString, double> &values = {});

/// Whether \p name can be that of a value: a letter, then letters, digits and underscores, and
/// none of an expression's own names.
[[nodiscard]] bool isValueName(const QString &name);

} // namespace cradle
