// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/law_programs.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <vector>

/// The numbers in what is said of a program, to be compared with what its law makes.
namespace cradle::told {

/// Of the first finding whose headline begins with \p headline: what stands below it.
inline QString bodyOf(const std::vector<LawDeviation> &found, const QString &headline)
{
    for (const LawDeviation &each : found) {
        if (each.message.startsWith(headline))
            return each.message.section(QLatin1Char('\n'), 2);
    }
    return {};
}

/// The numbers that stand in \p body where \p pattern has a #; none if it says something else.
/// A * stands for words.
inline std::vector<double> numbersIn(const QString &body, const char *pattern)
{
    QString expression = QRegularExpression::escape(QString::fromUtf8(pattern));
    expression.replace(QLatin1String("\\#"), QLatin1String("(-?[0-9.]+)"));
    expression.replace(QLatin1String("\\*"), QLatin1String("[\\w ]+"));
    const auto match = QRegularExpression(expression).match(body);
    std::vector<double> numbers;
    for (int i = 1; match.hasMatch() && i <= match.lastCapturedIndex(); ++i)
        numbers.push_back(match.captured(i).toDouble());
    return numbers;
}

/// Whether two numbers with three digits each can be the same.
inline bool isNear(double a, double b)
{
    return std::abs(a - b) <= 0.0101 * std::max(std::abs(a), std::abs(b)) + 1e-6;
}
inline bool isNear(Vec2 a, Vec2 b)
{
    return length(a - b) <= 0.0101 * std::max(length(a), length(b)) + 1e-6;
}

} // namespace cradle::told
