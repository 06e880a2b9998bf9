// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/number_text.h"

#include "views/theme.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double scientificFrom = 1e6;
constexpr double numberNoise = 1e-9; ///< of the scale: sums of doubles over a run stay below

QString withMinus(QString text)
{
    return text.replace(u'-', QChar(0x2212));
}

/// Of a number of \p size written with four digits; three at most.
int decimalsOfFour(double size)
{
    return std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 3);
}

} // namespace

QString fixedNumber(double value, int places)
{
    if (!std::isfinite(value))
        return QStringLiteral("–");
    if (std::abs(value) >= scientificFrom)
        return QString::number(value, 'e', 3);
    QString text;
    for (int decimals = 4; decimals >= 0; --decimals) {
        text = QString::number(value, 'f', decimals);
        if (text.size() <= places)
            break;
    }
    return text.toDouble() == 0.0 && text.startsWith(u'-') ? text.mid(1) : text;
}

QString fourDigits(double value)
{
    const double size = std::abs(value);
    if (!std::isfinite(value))
        return QStringLiteral("–");
    if (size == 0.0)
        return QStringLiteral("0");
    if (size >= 1e5 || size < 1e-2)
        return QString::number(value, 'e', 1);
    return QString::number(value, 'f', decimalsOfFour(size));
}

QString fullNumber(double value)
{
    if (!std::isfinite(value))
        return QStringLiteral("–");
    return withMinus(QString::number(value, 'g', QLocale::FloatingPointShortest));
}

QString shortNumber(double value, double scale)
{
    const double size = std::abs(value);
    if (!std::isfinite(value))
        return QStringLiteral("–");
    if (size == 0.0 || size < numberNoise * scale)
        return QStringLiteral("0");
    if (size >= scientificFrom || size < 1e-3)
        return withMinus(QString::number(value, 'e', 2));
    const int decimals = std::max(decimalsOfFour(size), size < 1e5 ? 1 : 0);
    return withMinus(QString::number(value, 'f', decimals));
}

QString withPower(const QString &number)
{
    const qsizetype e = number.indexOf(u'e');
    bool isNumber = false;
    const int exponent = number.sliced(e + 1).replace(QChar(0x2212), u'-').toInt(&isNumber);
    if (e < 0 || !isNumber)
        return number;
    const QString sign = exponent < 0 ? QString(QChar(0x207b)) : QString();
    QString digits = QString::number(std::abs(exponent));
    for (QChar &digit : digits)
        digit = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹").at(digit.digitValue());
    const QString times = number.first(e);
    const QString power = QStringLiteral("10") + sign + digits;
    if (times == u'1' || times == QStringLiteral("−1"))
        return times.chopped(1) + power;
    return QStringLiteral("%1·%2").arg(times, power);
}

QString withNumber(const QString &label, const QString &number)
{
    // An isolate from left to right.
    const QString shown = label.isRightToLeft() ? QChar(0x2066) + number + QChar(0x2069) : number;
    return QCoreApplication::translate("cradle::ChartPlot", "%1: %2", "curve, value")
        .arg(label, shown);
}

QString tickNumber(double value, double step)
{
    if (std::abs(value) < 0.5 * step)
        return QStringLiteral("0");
    if (std::abs(value) >= scientificFrom || step < 1e-4)
        return withPower(withMinus(QString::number(value, 'g', 3)));
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 4);
    return withMinus(QString::number(value, 'f', decimals));
}

QFont columnFont()
{
    // JetBrains Mono has a higher x than Inter.
    constexpr double factor = 0.9;
    QFont font = numericFont();
    if (font.pointSizeF() > 0.0)
        font.setPointSizeF(factor * font.pointSizeF());
    else
        font.setPixelSize(qRound(factor * font.pixelSize()));
    return font;
}

} // namespace cradle
