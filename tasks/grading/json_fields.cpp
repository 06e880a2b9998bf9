// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/json_fields.h"

#include "model/world/shortest_number.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct FieldsText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

} // namespace

JsonFields::JsonFields(const QJsonObject &object, const QString &source)
    : m_object(object)
    , m_source(source)
{
}

JsonFields::JsonFields(JsonFields &parent, const QString &key)
    : m_object(parent.object(key.toLatin1().constData()))
    , m_pointer(parent.m_pointer + QLatin1Char('/') + key)
    , m_root(parent.m_root)
{
}

JsonFields::JsonFields(JsonFields &parent, const QString &key, const QJsonValue &element,
                       qsizetype index)
    : m_object(element.toObject())
    , m_pointer(QStringLiteral("%1/%2/%3").arg(parent.m_pointer, key).arg(index))
    , m_root(parent.m_root)
{
    if (!element.isObject())
        refuse(QString(), FieldsText::tr("an object is right here"));
}

QJsonValue JsonFields::at(const char *key) const
{
    return m_object.value(QLatin1String(key));
}

bool JsonFields::has(const char *key) const
{
    const QJsonValue value = at(key);
    return !value.isUndefined() && !value.isNull();
}

void JsonFields::refuse(const QString &key, const QString &message)
{
    if (!m_root->m_fault)
        m_root->m_fault =
            Error{.message = message,
                  .file = m_root->m_source,
                  .pointer = key.isEmpty() ? m_pointer : m_pointer + QLatin1Char('/') + key};
}

void JsonFields::refuse(const char *key, const QString &right)
{
    refuse(QString::fromLatin1(key), FieldsText::tr("%1 is right here").arg(right));
}

QString JsonFields::text(const char *key, qsizetype mostLetters)
{
    const QJsonValue value = at(key);
    if (value.isString() && value.toString().size() <= mostLetters)
        return value.toString();
    refuse(key, FieldsText::tr("a text of at most %1 letters").arg(mostLetters));
    return {};
}

double JsonFields::number(const char *key, double low, double high)
{
    const QJsonValue value = at(key);
    const double number = value.toDouble(std::nan(""));
    if (number >= low && number <= high)
        return number;
    refuse(key,
           FieldsText::tr("a number from %1 to %2").arg(shortestNumber(low), shortestNumber(high)));
    return low;
}

qint64 JsonFields::integer(const char *key, qint64 low, qint64 high)
{
    // Twice with different defaults: only an integer gives the same.
    const QJsonValue value = at(key);
    const qint64 number = value.toInteger(0);
    if (number == value.toInteger(1) && number >= low && number <= high)
        return number;
    refuse(key, FieldsText::tr("a whole number from %1 to %2").arg(low).arg(high));
    return low;
}

bool JsonFields::flag(const char *key)
{
    const QJsonValue value = at(key);
    if (!value.isBool())
        refuse(key, FieldsText::tr("true or false"));
    return value.toBool();
}

QJsonArray JsonFields::list(const char *key, qsizetype most)
{
    const QJsonValue value = at(key);
    if (value.isArray() && value.toArray().size() <= most)
        return value.toArray();
    refuse(key, FieldsText::tr("a list of at most %1").arg(most));
    return {};
}

QJsonObject JsonFields::object(const char *key)
{
    const QJsonValue value = at(key);
    if (!value.isObject())
        refuse(key, FieldsText::tr("an object"));
    return value.toObject();
}

} // namespace cradle
