// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/unit_number.h"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace cradle {

namespace {

constexpr double highestPower = 9.0;

UnitPowers together(const UnitPowers &a, const UnitPowers &b, int times)
{
    return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}

QString withPower(const char *unit, int power)
{
    const QString name = QLatin1String(unit);
    if (power == 1)
        return name;
    if (power == 2 || power == 3)
        return name + (power == 2 ? QStringLiteral("²") : QStringLiteral("³"));
    return QStringLiteral("%1^%2").arg(name).arg(power);
}

} // namespace

QString nameOf(const UnitPowers &powers)
{
    QStringList above;
    QStringList below;
    const auto put = [&](const char *unit, int power) {
        if (power != 0)
            (power > 0 ? above : below).append(withPower(unit, std::abs(power)));
    };
    put("kg", powers[1]);
    put("m", powers[0]);
    put("s", powers[2]);
    const QString top = above.isEmpty() ? QStringLiteral("1") : above.join(QLatin1Char(' '));
    return below.isEmpty() ? top : top + QLatin1Char('/') + below.join(QLatin1Char(' '));
}

UnitNumber UnitNumber::measured(double number, const UnitPowers &powers)
{
    return {number, powers == UnitPowers{} ? Kind::Bare : Kind::Measured, powers};
}

bool UnitNumber::fits(const UnitNumber &other) const
{
    return kind != Kind::Measured || other.kind != Kind::Measured || powers == other.powers;
}

UnitNumber likeBoth(const UnitNumber &a, const UnitNumber &b, double number)
{
    const bool isFirst = a.kind == UnitNumber::Kind::Measured || b.kind == UnitNumber::Kind::Bare;
    const UnitNumber &told = isFirst ? a : b;
    return {number, told.kind, told.powers};
}

UnitNumber timesPower(const UnitNumber &a, const UnitNumber &b, int way)
{
    const double number = way > 0 ? a.number * b.number : a.number / b.number;
    if (a.kind == UnitNumber::Kind::Any || b.kind == UnitNumber::Kind::Any)
        return {number, UnitNumber::Kind::Any, {}};
    return UnitNumber::measured(number, together(a.powers, b.powers, way));
}

std::optional<UnitNumber> raised(const UnitNumber &base, const UnitNumber &exponent)
{
    const double number = std::pow(base.number, exponent.number);
    if (exponent.kind == UnitNumber::Kind::Measured)
        return std::nullopt;
    if (base.kind != UnitNumber::Kind::Measured)
        return UnitNumber{number, base.kind, {}};
    UnitPowers powers{};
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const double power = base.powers[i] * exponent.number;
        if (power != std::round(power) || std::abs(power) > highestPower)
            return std::nullopt;
        powers[i] = static_cast<int>(power);
    }
    return UnitNumber::measured(number, powers);
}

std::optional<UnitText> unitAt(const QString &text, qsizetype from,
                               const std::function<bool(const QString &)> &isTaken)
{
    static const QRegularExpression form(QStringLiteral(
        "\\G(\\s*[*/]\\s*|\\s*)([\\p{L}°%]+)([²³]|\\^-?\\d)?(?![\\p{L}\\d_]|\\s*\\()"));
    qsizetype end = from;
    for (;;) {
        const QRegularExpressionMatch match = form.match(text, end);
        const bool isFirst = end == from;
        const bool goesOn =
            match.hasMatch()
            && (isFirst ? match.captured(1).trimmed().isEmpty() : !isTaken(match.captured(2)));
        if (!goesOn || !unitFrom(match.captured(2)))
            break;
        end = match.capturedEnd();
    }
    const QString written = text.mid(from, end - from);
    const auto unit = unitFrom(written);
    return end > from && unit ? std::optional(UnitText{*unit, end}) : std::nullopt;
}

UnitNumber inUnit(double number, const Unit &unit)
{
    constexpr double decimals = 1e6;
    const double parts = std::round(decimals / unit.scale) / decimals;
    const double value =
        std::abs(parts * unit.scale - 1.0) < 1e-15 ? number / parts : number * unit.scale;
    return UnitNumber::measured(value, unit.powers);
}

std::optional<UnitNumber> askedUnit(const QString &unit)
{
    static const QRegularExpression form(QStringLiteral("^\\s*·?\\s*(\\d*)\\s*(.*)$"));
    const QRegularExpressionMatch match = form.match(unit);
    const auto read = unitFrom(match.captured(2));
    if (!read || read->powers == UnitPowers{})
        return std::nullopt;
    const double factor = match.captured(1).isEmpty() ? 1.0 : match.captured(1).toDouble();
    return UnitNumber::measured(factor * read->scale, read->powers);
}

} // namespace cradle
