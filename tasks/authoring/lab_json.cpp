// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_json.h"

#include "model/files/json_schema.h"
#include "tasks/authoring/json_patch.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct LabJsonText {
    Q_DECLARE_TR_FUNCTIONS(LabFiles)
};

QString resourceOf(const char *schema)
{
    return QLatin1String(":/schemas/") + QLatin1String(schema);
}

} // namespace

Result<QJsonObject> jsonOf(const LabFiles &files, const QString &path, const char *schema)
{
    const auto found = files.contents.find(path);
    if (found == files.contents.end())
        return Error{.message = LabJsonText::tr("cannot be read: there is no such file"),
                     .file = path};
    return parseJson(*found, resourceOf(schema), path);
}

Result<LabFiles> withPatch(const LabFiles &files, const QString &path, const char *schema,
                           const QJsonObject &before, const QJsonObject &after)
{
    if (before == after)
        return files;
    const QByteArray text = files.contents.value(path, "{}\n");
    const QByteArray patched = patchJson(text, before, after);
    const Result<QJsonObject> checked = parseJson(patched, resourceOf(schema), path);
    if (!checked)
        return checked.error();
    LabFiles result = files;
    result.contents.insert(path, patched);
    return result;
}

Result<LabFiles> withMember(const LabFiles &files, const QString &path, const char *schema,
                            const QString &key, const QJsonValue &value)
{
    QJsonObject before;
    if (files.contents.contains(path)) {
        const Result<QJsonObject> json = jsonOf(files, path, schema);
        if (!json)
            return json.error();
        before = *json;
    }
    QJsonObject after = before;
    if (value.isUndefined())
        after.remove(key);
    else
        after.insert(key, value);
    return withPatch(files, path, schema, before, after);
}

QString ownLanguage(const LabFiles &files)
{
    const Result<QJsonObject> json = jsonOf(files, QStringLiteral("lab.json"), labSchema);
    const QString language = json ? json->value(QStringLiteral("language")).toString() : QString();
    return language.isEmpty() ? QStringLiteral("en") : language;
}

bool isTranslation(const LabFiles &files, const QString &language)
{
    return !language.isEmpty() && language != ownLanguage(files);
}

QString taskPath(const QString &step)
{
    return step + QStringLiteral("/task.json");
}

QStringList translationsOf(const LabFiles &files, const QString &step)
{
    const QString start = step + QStringLiteral("/task.");
    QStringList paths;
    for (auto it = files.contents.lowerBound(start);
         it != files.contents.end() && it.key().startsWith(start); ++it) {
        if (it.key() != step + QStringLiteral("/task.json")
            && it.key().endsWith(QLatin1String(".json")))
            paths.append(it.key());
    }
    return paths;
}

QString translatedPath(const QString &path, const QString &language)
{
    return path.chopped(5) + QLatin1Char('.') + language + QStringLiteral(".json");
}

LabFiles withTranslatedKey(const LabFiles &files, const QString &step, const QString &object,
                           const QString &name, const QString &newName)
{
    LabFiles result = files;
    for (const QString &path : translationsOf(files, step)) {
        const Result<QJsonObject> json = jsonOf(files, path, translationSchema);
        if (!json)
            continue;
        QJsonObject texts = json->value(object).toObject();
        if (!texts.contains(name))
            continue;
        const QJsonValue text = texts.take(name);
        if (!newName.isEmpty())
            texts.insert(newName, text);
        Result<LabFiles> changed = withMember(result, path, translationSchema, object, texts);
        if (changed)
            result = std::move(*changed);
    }
    return result;
}

QJsonArray toJson(const QStringList &list)
{
    return QJsonArray::fromStringList(list);
}

QStringList toStrings(const QJsonValue &list)
{
    QStringList strings;
    for (const QJsonValue &value : list.toArray())
        strings.append(value.toString());
    return strings;
}

} // namespace cradle
