// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/parameter_text.h"

#include "model/files/expression.h"
#include "model/world/shortest_number.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

using Type = ParameterInfo::Type;

struct ParameterMessage {
    Q_DECLARE_TR_FUNCTIONS(ParameterText)
};

const QString opening = QStringLiteral("{{");
const QString closing = QStringLiteral("}}");

bool isMarked(const QString &text)
{
    return text.startsWith(opening) && text.endsWith(closing);
}

/// A number so that 1/30 stays that; an expression as it was typed, but with its marks, {{k}},
/// where it needs the values of the lab.
QString numberText(const QJsonValue &value)
{
    if (!value.isString())
        return fractionOrNumber(value.toDouble());
    const QString text = value.toString();
    const QString inner = text.mid(opening.size()).chopped(closing.size());
    return isMarked(text) && evaluated(inner) ? inner : text;
}

/// What keeps a number as it was typed: an expression without units, which its place in the file
/// may not know, and which is no other way to write the number.
QJsonValue kept(const QString &typed, double number)
{
    bool isPlain = false;
    (void)typed.toDouble(&isPlain);
    const bool hasUnit =
        !evaluated(typed, {}, QStringLiteral("m")) || !evaluated(typed, {}, QStringLiteral("s"));
    if (isPlain || hasUnit || fractionOrNumber(number) == typed)
        return number;
    return QString(opening + typed + closing);
}

QString listText(const QJsonArray &list)
{
    QStringList texts;
    for (const QJsonValue &value : list)
        texts.append(numberText(value));
    return texts.join(QStringLiteral(", "));
}

QString unitOf(const ParameterInfo &info)
{
    if (info.unit.isEmpty())
        return {};
    // One that begins with a number is none after a number: 1000 kg/m³.
    return info.unit.front().isDigit() ? ParameterMessage::tr(", in %1").arg(info.unit)
                                       : QLatin1Char(' ') + info.unit;
}

QString boundsOf(const ParameterInfo &info)
{
    const QString unit = unitOf(info);
    if (info.least && info.most)
        return ParameterMessage::tr("from %1 to %2%3")
            .arg(shortestNumber(*info.least), shortestNumber(*info.most), unit);
    return info.least ? ParameterMessage::tr("%1%2 or more").arg(shortestNumber(*info.least), unit)
                      : ParameterMessage::tr("any%1").arg(unit);
}

Error rightWouldBe(const ParameterInfo &info)
{
    switch (info.type) {
    case Type::Count:
        return {.message = ParameterMessage::tr("%1: a whole number, %2, is right")
                               .arg(info.label, boundsOf(info))};
    case Type::Vector:
        return {.message = ParameterMessage::tr("%1: two numbers as “2, 0”, %2, are right")
                               .arg(info.label, boundsOf(info))};
    case Type::Range:
        return {.message = ParameterMessage::tr("%1: the least and the most as “0.5, 2”, %2, are "
                                                "right")
                               .arg(info.label, boundsOf(info))};
    case Type::Vectors:
        return {.message = ParameterMessage::tr("%1: pairs of numbers as “2, 0; 0, 0”, %2, are "
                                                "right")
                               .arg(info.label, boundsOf(info))};
    case Type::Numbers:
        return {.message = ParameterMessage::tr("%1: numbers as “0.5, 1”, %2, are right")
                               .arg(info.label, boundsOf(info))};
    default:
        return {
            .message =
                ParameterMessage::tr("%1: a number, %2, is right").arg(info.label, boundsOf(info))};
    }
}

/// The parts of a list: between commas that stand in no parenthesis, or, where there are none,
/// between spaces.
QStringList partsOf(const ParameterInfo &info, const QString &text)
{
    QStringList parts{QString()};
    int depth = 0;
    for (const QChar letter : text.trimmed()) {
        depth += letter == QLatin1Char('(') ? 1 : letter == QLatin1Char(')') ? -1 : 0;
        if (letter == QLatin1Char(',') && depth == 0)
            parts.append(QString());
        else
            parts.last().append(letter);
    }
    static const QRegularExpression spaces(QStringLiteral("\\s+"));
    const bool isList = info.type != Type::Number && info.type != Type::Count;
    const QStringList words = parts.front().split(spaces);
    const bool areNumbers = std::all_of(words.begin(), words.end(), [&](const QString &word) {
        return evaluated(word, {}, info.unit).ok();
    });
    return isList && parts.size() == 1 && areNumbers ? words : parts;
}

/// The numbers in \p text; none if one is no number or out of range.
std::optional<QJsonArray> numbersFrom(const ParameterInfo &info, const QString &text)
{
    QJsonArray numbers;
    for (const QString &each : partsOf(info, text)) {
        const QString part = each.trimmed();
        if (isMarked(part)) {
            numbers.append(part); // judged with the values of the lab
            continue;
        }
        const Result<double> number = evaluated(part, {}, info.unit);
        if (!number || (info.least && *number < *info.least) || (info.most && *number > *info.most))
            return std::nullopt;
        numbers.append(kept(part, *number));
    }
    return numbers;
}

} // namespace

QString textOfParameter(const ParameterInfo &info, const QJsonValue &value)
{
    if (value.isUndefined() || value.isNull())
        return {};
    switch (info.type) {
    case Type::Number:
    case Type::Count:
        return numberText(value);
    case Type::Vector:
    case Type::Range:
    case Type::Numbers:
        return listText(value.toArray());
    case Type::Vectors: {
        QStringList pairs;
        for (const QJsonValue &pair : value.toArray())
            pairs.append(listText(pair.toArray()));
        return pairs.join(QStringLiteral("; "));
    }
    case Type::Flag:
        return value.toBool() ? ParameterMessage::tr("yes") : ParameterMessage::tr("no");
    case Type::Choices: {
        QStringList names;
        for (const QJsonValue &name : value.toArray())
            names.append(name.toString());
        return names.join(QStringLiteral(", "));
    }
    case Type::Choice:
    case Type::Script:
        break;
    }
    return value.toString();
}

Result<QJsonValue> parameterFromText(const ParameterInfo &info, const QString &text)
{
    if (text.trimmed().isEmpty())
        return QJsonValue(QJsonValue::Undefined);
    if (info.type == Type::Choice || info.type == Type::Script)
        return QJsonValue(text.trimmed());
    if (info.type == Type::Vectors) {
        QJsonArray pairs;
        for (const QString &pair : text.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
            const auto numbers = numbersFrom(info, pair);
            if (!numbers || numbers->size() != 2)
                return rightWouldBe(info);
            pairs.append(*numbers);
        }
        return QJsonValue(pairs);
    }
    const auto numbers = numbersFrom(info, text);
    if (!numbers)
        return rightWouldBe(info);
    const bool pair = info.type == Type::Vector || info.type == Type::Range;
    if (pair)
        return numbers->size() == 2 ? Result<QJsonValue>(QJsonValue(*numbers))
                                    : Result<QJsonValue>(rightWouldBe(info));
    if (info.type == Type::Numbers)
        return QJsonValue(*numbers);
    if (numbers->size() != 1)
        return rightWouldBe(info);
    const QJsonValue one = numbers->at(0);
    const Result<double> number = evaluated(numberText(one)); // none of a value
    const bool whole = info.type != Type::Count || !number || std::floor(*number) == *number;
    return whole ? Result<QJsonValue>(one) : Result<QJsonValue>(rightWouldBe(info));
}

} // namespace cradle
