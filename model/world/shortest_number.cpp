// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/shortest_number.h"

#include <cmath>
#include <cstdlib>

namespace cradle {

namespace {

constexpr double longestPart = 100'000.0;  ///< n of 1/n
constexpr double longestFraction = 1000.0; ///< n of m/n
constexpr qsizetype saved = 3;             ///< letters, below which a decimal is as good

QString whole(double number)
{
    return QString::number(number, 'f', 0);
}

} // namespace

QString shortestNumber(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString fractionOrNumber(double value)
{
    const QString decimal = shortestNumber(value);
    const auto isShorter = [&](const QString &text) {
        return decimal.size() > text.size() + saved;
    };
    const double part = std::round(1.0 / value);
    if (part >= 2.0 && part <= longestPart && 1.0 / part == value) {
        const QString text = QStringLiteral("1/") + whole(part);
        return isShorter(text) ? text : decimal;
    }
    constexpr qsizetype shortest = 4; // as 2/3
    if (decimal.size() <= shortest + saved || std::abs(value) > longestFraction)
        return decimal;
    for (double n = 2.0; n <= longestFraction; ++n) {
        const double m = std::round(value * n);
        if (m / n != value)
            continue;
        const QString text = whole(m) + u'/' + whole(n);
        return isShorter(text) ? text : decimal;
    }
    return decimal;
}

} // namespace cradle
