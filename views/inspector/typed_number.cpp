// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/typed_number.h"

#include "model/files/expression.h"

#include <cmath>

namespace cradle {

namespace {

constexpr int cleanDigits = 12; ///< of a spun number; a double holds nearly 16

} // namespace

std::optional<double> readNumber(const QString &text, const QString &unit)
{
    QString plain = text.trimmed();
    if (!plain.contains(QLatin1Char('('))) // there a comma is between arguments
        plain.replace(QLatin1Char(','), QLatin1Char('.'));
    Result<double> value = evaluated(plain, {}, unit);
    if (!value && !unit.isEmpty() && plain.endsWith(unit)) // one that is only a name, as "steps"
        value = evaluated(plain.chopped(unit.size()), {}, unit);
    return value ? std::optional(*value) : std::nullopt;
}

double spun(double value, double step, int steps)
{
    const double next = value + steps * step;
    if (std::abs(next) < step * 1e-9)
        return 0.0;
    return QString::number(next, 'g', cleanDigits).toDouble();
}

} // namespace cradle
