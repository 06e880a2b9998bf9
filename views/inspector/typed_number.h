// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace cradle {

/// The number that a person typed: with a decimal point or comma, a minus sign of either kind,
/// an exponent (1e-3), as an expression (1/240, 1 + 0.42*cos(pi/6)), and perhaps \p unit behind it
/// or one that can be turned into it (20 cm for m).
/// Finite, else nullopt.
[[nodiscard]] std::optional<double> readNumber(const QString &text, const QString &unit = {});

/// The number \p steps times \p step on, on the grid of \p step if it was there, without the
/// digits that rounding leaves behind (0.1 + 0.2 is 0.3).
[[nodiscard]] double spun(double value, double step, int steps);

} // namespace cradle
