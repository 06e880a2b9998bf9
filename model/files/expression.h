// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QMap>

namespace cradle {

/// The number that an expression comes to: numbers, the names of \p values, pi; + - * / ^ with the
/// usual precedence (^ binds to the right and before a sign), parentheses; sqrt, abs, exp, ln,
/// log10, sin, cos, tan, asin, acos, atan (radians), floor, ceil, round, min, max, atan2.
///
/// A number or a parenthesis may have a unit behind it (20 cm, 36 km/h, 9.81 m/s^2, 30°; see
/// unitFrom()): then units are reckoned with, and the result is in \p unit. What is written without
/// a unit, or is made of a value, whose unit is not known, is taken as it is.
/// \param text  at most 400 characters
/// \param unit  what is asked for, as "m/s²"; empty: units of the SI
/// \return an error that says what is wrong with it; also if the number is not finite, or is in a
///     unit that cannot be \p unit
[[nodiscard]] Result<double>
evaluated(const QString &text, const QMap<QString, double> &values = {}, const QString &unit = {});

/// Whether \p name can be that of a value: a letter, then letters, digits and underscores, and
/// none of an expression's own names.
[[nodiscard]] bool isValueName(const QString &name);

} // namespace cradle
