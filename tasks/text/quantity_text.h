// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// A physical quantity as the lab's texts, its code and the window write it in every language: with
/// a point and a true minus. Counts, points and dates follow the language.
/// \param format, precision  as those of QString::number()
[[nodiscard]] inline QString quantityText(double value, char format, int precision)
{
    return QString::number(value, format, precision).replace(u'-', QChar(0x2212));
}

} // namespace cradle
