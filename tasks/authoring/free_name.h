// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// \p wish, or with the first number from 2 under which nothing goes yet: "check-2".
/// \param separator  before the number
/// \param isTaken  whether a name is; if all of the first thousand are, so may the answer be
template <typename IsTaken>
[[nodiscard]] QString freeName(const QString &wish, IsTaken isTaken,
                               const QString &separator = QStringLiteral("-"))
{
    QString name = wish;
    for (int number = 2; isTaken(name) && number <= 1000; ++number)
        name = wish + separator + QString::number(number);
    return name;
}

} // namespace cradle
