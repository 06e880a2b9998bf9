// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/unit.h"

#include <QRegularExpression>

#include <cmath>
#include <numbers>

namespace cradle {

namespace {

struct NamedUnit {
    const char *symbol;
    Unit unit;
    bool takesPrefix;
};

const NamedUnit units[] = {
    {"m", {1.0, {1, 0, 0}}, true},
    {"g", {1e-3, {0, 1, 0}}, true},
    {"s", {1.0, {0, 0, 1}}, true},
    {"min", {60.0, {0, 0, 1}}, false},
    {"h", {3600.0, {0, 0, 1}}, false},
    {"N", {1.0, {1, 1, -2}}, true},
    {"J", {1.0, {2, 1, -2}}, true},
    {"W", {1.0, {2, 1, -3}}, true},
    {"Pa", {1.0, {-1, 1, -2}}, true},
    {"Hz", {1.0, {0, 0, -1}}, true},
    {"t", {1000.0, {0, 1, 0}}, false},
    {"rad", {1.0, {}}, false},
    {"%", {0.01, {}}, false},
    {"1", {1.0, {}}, false},
    {"°", {std::numbers::pi / 180.0, {}}, false},
};

struct Prefix {
    const char *symbol;
    double scale;
};

constexpr Prefix prefixes[] = {{"k", 1e3}, {"c", 1e-2}, {"m", 1e-3}, {"d", 1e-1}, {"M", 1e6},
                               {"G", 1e9}, {"h", 1e2},  {"µ", 1e-6}, {"u", 1e-6}, {"n", 1e-9}};

std::optional<Unit> named(const QString &symbol)
{
    for (const NamedUnit &each : units) {
        if (symbol == QString::fromUtf8(each.symbol))
            return each.unit;
    }
    for (const Prefix &prefix : prefixes) {
        const QString start = QString::fromUtf8(prefix.symbol);
        if (!symbol.startsWith(start))
            continue;
        for (const NamedUnit &each : units) {
            if (each.takesPrefix && symbol.mid(start.size()) == QString::fromUtf8(each.symbol))
                return Unit{prefix.scale * each.unit.scale, each.unit.powers};
        }
    }
    return std::nullopt;
}

/// "s^-1" and "s⁻¹" as symbol and power.
std::optional<Unit> factorFrom(QString text)
{
    static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    qsizetype end = text.size();
    while (end > 0 && (raised.contains(text[end - 1]) || text[end - 1] == u'⁻'))
        --end;
    QString power;
    for (const QChar letter : text.mid(end))
        power += letter == u'⁻' ? QStringLiteral("-") : QString::number(raised.indexOf(letter));
    text.truncate(end);
    if (const auto caret = text.indexOf(u'^'); caret >= 0 && power.isEmpty()) {
        power = text.mid(caret + 1).replace(QChar(0x2212), u'-');
        text.truncate(caret);
        if (power.isEmpty())
            return std::nullopt;
    }
    bool isNumber = true;
    const int n = power.isEmpty() ? 1 : power.toInt(&isNumber);
    const auto base = named(text);
    if (!base || !isNumber || std::abs(n) > 9)
        return std::nullopt;
    Unit unit{std::pow(base->scale, n), base->powers};
    for (int &each : unit.powers)
        each *= n;
    return unit;
}

} // namespace

std::optional<Unit> unitFrom(const QString &text)
{
    static const QRegularExpression between(QStringLiteral("[\\s·⋅*×]+"));
    Unit unit;
    if (text.trimmed().isEmpty())
        return unit;
    bool isBelow = false;
    for (const QString &part : text.trimmed().split(u'/')) {
        const QStringList factors = part.split(between, Qt::SkipEmptyParts);
        if (factors.isEmpty())
            return std::nullopt;
        for (const QString &factor : factors) {
            const auto each = factorFrom(factor);
            if (!each)
                return std::nullopt;
            unit.scale *= isBelow ? 1.0 / each->scale : each->scale;
            for (std::size_t i = 0; i < unit.powers.size(); ++i)
                unit.powers[i] += isBelow ? -each->powers[i] : each->powers[i];
        }
        isBelow = true;
    }
    return unit;
}

std::optional<Quantity> quantityFrom(const QString &text)
{
    static const QRegularExpression form(
        QStringLiteral("^([+-]?(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?)\\s*(.*)$"));
    QString plain = text.trimmed();
    plain.replace(QChar(0x2212), u'-').replace(u',', u'.');
    const auto match = form.match(plain);
    if (!match.hasMatch())
        return std::nullopt;
    const double number = match.captured(1).toDouble();
    if (!std::isfinite(number))
        return std::nullopt;
    return Quantity{number, match.captured(2)};
}

} // namespace cradle
