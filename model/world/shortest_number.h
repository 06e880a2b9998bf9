// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

namespace cradle {

/// The fewest digits that read back to the same double, as in files and on the terminal.
[[nodiscard]] QString shortestNumber(double value);

/// "1/60", "-2/3" where the number is that fraction to the last bit, and its decimal is longer by
/// more than three letters; else shortestNumber(). Denominators to 1000, of 1/n to 100 000. For
/// fields in which fractions may be typed.
[[nodiscard]] QString fractionOrNumber(double value);

} // namespace cradle
