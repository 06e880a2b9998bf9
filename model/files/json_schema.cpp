// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/json_schema.h"

#include "model/world/shortest_number.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>

#include <valijson/adapters/qtjson_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace cradle {

namespace {

struct SchemaText {
    Q_DECLARE_TR_FUNCTIONS(Schema)
};

/// A schema, as text for explanations and made ready for use.
struct ReadySchema {
    QJsonObject json{};
    valijson::Schema schema{};
    valijson::Validator validator{}; ///< it keeps the patterns that it has made ready
};

/// Each is made ready once in a thread: for the many files of a lab that takes longer than all
/// else.
ReadySchema &schemaAt(const QString &resource)
{
    thread_local std::map<QString, ReadySchema> schemas;
    const auto found = schemas.find(resource);
    if (found != schemas.end())
        return found->second;
    QFile file(resource);
    const bool open = file.open(QIODevice::ReadOnly);
    Q_ASSERT_X(open, "schemaAt", qPrintable(resource));
    ReadySchema &ready = schemas[resource];
    ready.json = QJsonDocument::fromJson(file.readAll()).object();
    valijson::SchemaParser().populateSchema(
        valijson::adapters::QtJsonAdapter(QJsonValue(ready.json)), ready.schema);
    return ready;
}

/// One step of a JSON pointer: "~" and "/" are escaped (RFC 6901).
QString pointerStep(QString key)
{
    key.replace(QLatin1Char('~'), QStringLiteral("~0"));
    key.replace(QLatin1Char('/'), QStringLiteral("~1"));
    return QLatin1Char('/') + key;
}

/// A node of a schema and the value that it speaks of, walked down together.
struct Place {
    QJsonObject root;
    QJsonObject node;
    QJsonValue value;
    QString pointer{};

    void enter(const QString &key)
    {
        if (value.isArray()) {
            node = node.value(QStringLiteral("items")).toObject();
            value = value.toArray().at(key.toInt());
        } else {
            const QJsonValue named = node.value(QStringLiteral("properties")).toObject().value(key);
            const QJsonValue others = node.value(QStringLiteral("additionalProperties"));
            node = (named.isUndefined() ? others : named).toObject();
            value = value.toObject().value(key);
        }
        pointer += pointerStep(key);
        resolve();
    }

    /// Follows $ref, and of anyOf takes the branch of the value's own type.
    void resolve()
    {
        const QString ref = node.value(QStringLiteral("$ref")).toString();
        if (!ref.isEmpty()) {
            const QString name = ref.section(QLatin1Char('/'), -1);
            node = root.value(QStringLiteral("definitions")).toObject().value(name).toObject();
        }
        if (!value.isArray() && !value.isObject())
            return;
        const QString type = value.isArray() ? QStringLiteral("array") : QStringLiteral("object");
        for (const QJsonValue &branch : node.value(QStringLiteral("anyOf")).toArray()) {
            const QJsonObject candidate = branch.toObject();
            if (candidate.value(QStringLiteral("type")).toString() == type) {
                node = candidate;
                return;
            }
        }
    }
};

QString shown(const QJsonValue &value)
{
    if (value.isArray())
        return SchemaText::tr("a list of %n value(s)", nullptr,
                              static_cast<int>(value.toArray().size()));
    if (value.isObject())
        return SchemaText::tr("an object");
    if (value.isString())
        return QStringLiteral("\"%1\"").arg(value.toString().left(60));
    if (value.isDouble())
        return shortestNumber(value.toDouble());
    return value.toVariant().toString().isEmpty() ? QStringLiteral("null")
                                                  : value.toVariant().toString();
}

/// Says what is wrong at \p place and, by the schema's own description, what would be right.
Error explain(Place place, const QString &source)
{
    const QJsonObject properties = place.node.value(QStringLiteral("properties")).toObject();
    if (place.value.isObject() && !properties.isEmpty()) {
        const QJsonObject object = place.value.toObject();
        const QStringList keys = object.keys();
        for (const QString &key : keys) {
            if (!properties.contains(key)) {
                return {.message =
                            SchemaText::tr("unknown key \"%1\"; the keys here are %2")
                                .arg(key.left(60), properties.keys().join(QStringLiteral(", "))),
                        .file = source,
                        .pointer = place.pointer + pointerStep(key.left(60))};
            }
        }
        for (const QJsonValue &required : place.node.value(QStringLiteral("required")).toArray()) {
            if (!object.contains(required.toString())) {
                return {.message = SchemaText::tr("\"%1\" is missing").arg(required.toString()),
                        .file = source,
                        .pointer = place.pointer};
            }
        }
    }
    const QByteArray description =
        place.node.value(QStringLiteral("description")).toString().toUtf8();
    return {.message = SchemaText::tr("%1 is not right here; right would be %2")
                           .arg(shown(place.value), SchemaText::tr(description.constData())),
            .file = source,
            .pointer = place.pointer};
}

/// A file of a later version: what else is strange in it is no mistake of its author.
std::optional<Error> newerFormat(const QJsonObject &object, const QJsonObject &schema,
                                 const QString &source)
{
    const QString key = QStringLiteral("format");
    const QJsonArray known = schema.value(QStringLiteral("properties"))
                                 .toObject()
                                 .value(key)
                                 .toObject()
                                 .value(QStringLiteral("enum"))
                                 .toArray();
    const double format = object.value(key).toDouble();
    if (known.isEmpty() || format <= known.last().toDouble())
        return std::nullopt;
    return Error{.message =
                     SchemaText::tr("needs a newer Cradle: format %1, this one reads %2")
                         .arg(shortestNumber(format), shortestNumber(known.last().toDouble())),
                 .file = source,
                 .pointer = QLatin1Char('/') + key};
}

Error syntaxError(const QByteArray &text, const QJsonParseError &fault, const QString &source)
{
    const auto line = 1 + text.left(fault.offset).count('\n');
    return {.message = SchemaText::tr("this is not JSON: %1").arg(fault.errorString()),
            .file = source,
            .line = static_cast<int>(line)};
}

} // namespace

Result<QByteArray> readFile(const QString &path, qint64 maxBytes)
{
    QFile file(path);
    if (QFileInfo(path).isDir())
        return Error{.message = SchemaText::tr("this is a folder; a file is right"), .file = path};
    if (!file.open(QIODevice::ReadOnly))
        return Error{.message = SchemaText::tr("cannot be read: %1").arg(file.errorString()),
                     .file = path};
    // Room is taken for what there is, not for all that may be; some sizes are not known before.
    constexpr qint64 part = 64 * 1024;
    QByteArray text = file.read(std::min(maxBytes, file.size()) + 1);
    for (QByteArray more = file.read(part); text.size() <= maxBytes && !more.isEmpty();
         more = file.read(part))
        text += more;
    if (text.size() > maxBytes) {
        return Error{.message = SchemaText::tr("the file is too large; at most %1 are right")
                                    .arg(QLocale::c().formattedDataSize(maxBytes)),
                     .file = path};
    }
    return text;
}

Result<QJsonObject> parseJson(const QByteArray &text, const QString &schemaResource,
                              const QString &source)
{
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(text, &fault);
    if (fault.error != QJsonParseError::NoError)
        return syntaxError(text, fault, source);

    ReadySchema &schema = schemaAt(schemaResource);
    if (const auto newer = newerFormat(document.object(), schema.json, source))
        return *newer;
    const QJsonValue value =
        document.isObject() ? QJsonValue(document.object()) : QJsonValue(document.array());
    valijson::ValidationResults results;
    const valijson::adapters::QtJsonAdapter target(value);
    if (schema.validator.validate(schema.schema, target, &results))
        return document.object();

    // The deepest place says most: an error inside a branch of anyOf is reported there too.
    std::vector<std::string> deepest{"<root>"};
    for (const auto &error : results) {
        if (error.context.size() > deepest.size())
            deepest = error.context;
    }
    Place place{schema.json, schema.json, value};
    for (std::size_t i = 1; i < deepest.size(); ++i)
        place.enter(QString::fromStdString(deepest[i].substr(1, deepest[i].size() - 2)));
    return explain(place, source);
}

} // namespace cradle
