// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QString>

namespace cradle {

/// For columns of numbers: four decimals, fewer where they would not fit \p places characters, or
/// scientific from 10⁶ on; never "-0.0000".
[[nodiscard]] QString fixedNumber(double value, int places = 11);

/// Four digits, for columns with no room for more.
[[nodiscard]] QString fourDigits(double value);

/// All digits of a number, as few as tell it from every other one.
[[nodiscard]] QString fullNumber(double value);

/// For labels and sentences: four digits, and below 10⁵ at least one decimal. What is below
/// rounding noise (10⁻⁹) of \p scale is "0".
[[nodiscard]] QString shortNumber(double value, double scale = 0.0);

/// "2.96e+06" as "2.96·10⁶", for eyes only; other numbers stay as they are.
[[nodiscard]] QString withPower(const QString &number);

/// "label: −1.5"; where \p label is read from the right the number has its sign in front even so.
[[nodiscard]] QString withNumber(const QString &label, const QString &number);

/// For a tick of an axis whose ticks are \p step apart: no more decimals than the step needs.
[[nodiscard]] QString tickNumber(double value, double step);

/// The font of columns of numbers: its figures look as large as the text beside them.
[[nodiscard]] QFont columnFont();

} // namespace cradle
