// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_reader.h"

#include "model/json_schema.h"
#include "model/preset_json.h"
#include "tasks/checks/check_validation.h"
#include "tasks/known_scripts.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonArray>
#include <QStringDecoder>

#include <algorithm>

namespace cradle {

namespace {

struct ReaderText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

/// Far above what a step needs; a larger file is a mistake.
constexpr qint64 maxTextBytes = 2 * 1024 * 1024;

Result<QJsonObject> readJson(const QString &path, const char *schema)
{
    const Result<QByteArray> text = readFile(path, maxTextBytes);
    if (!text)
        return text.error();
    return parseJson(*text, QLatin1String(":/schemas/") + QLatin1String(schema), path);
}

/// The texts of "NAME.LANGUAGE.json" beside "NAME.json"; empty if there are none.
QJsonObject translationOf(const QString &path, const QString &language, Lab &lab)
{
    QString translated = path;
    translated.replace(QStringLiteral(".json"),
                       QLatin1Char('.') + language + QStringLiteral(".json"));
    if (!QFile::exists(translated))
        return {};
    const Result<QJsonObject> json = readJson(translated, "translation.schema.json");
    if (json)
        return *json;
    lab.findings.push_back(json.error());
    return {};
}

QString textOf(const QString &folder, const QString &language, Lab &lab)
{
    const QString own = folder + QStringLiteral("/instructions.md");
    const QString translated = folder + QStringLiteral("/instructions.%1.md").arg(language);
    const QString path = QFile::exists(translated) ? translated : own;
    const Result<QByteArray> text = readFile(path, maxTextBytes);
    if (!text) {
        lab.findings.push_back(text.error());
        return {};
    }
    QStringDecoder decode(QStringDecoder::Utf8);
    const QString decoded = decode(*text);
    if (decode.hasError())
        lab.findings.push_back({.message = ReaderText::tr("the text is not in UTF-8, which would "
                                                          "be right; some letters are lost"),
                                .file = path});
    return decoded;
}

QStringList stringsOf(const QJsonValue &list)
{
    QStringList strings;
    for (const QJsonValue &value : list.toArray())
        strings.append(value.toString());
    return strings;
}

std::vector<CheckSpec> checksOf(const QJsonObject &json, const QJsonObject &titles)
{
    std::vector<CheckSpec> checks;
    for (const QJsonValue &value : json.value(QStringLiteral("checks")).toArray()) {
        const QJsonObject object = value.toObject();
        CheckSpec check;
        check.id = object.value(QStringLiteral("id")).toString();
        check.kind = object.value(QStringLiteral("kind")).toString();
        check.title =
            titles.value(check.id).toString(object.value(QStringLiteral("title")).toString());
        check.parameters = object.value(QStringLiteral("parameters")).toObject();
        check.scene = object.value(QStringLiteral("scene")).toObject();
        check.points = object.value(QStringLiteral("points")).toDouble(1.0);
        for (const QJsonValue &circle : object.value(QStringLiteral("circles")).toArray())
            check.circles.push_back(circle.toInt() - 1);
        if (check.circles.empty())
            check.circles = {0};
        checks.push_back(check);
    }
    return checks;
}

/// The scene that passes the step, where the lab has one.
std::optional<Preset> solutionOf(const QString &folder, Lab &lab)
{
    const QString path = folder + QStringLiteral("/solution-preset.json");
    if (!QFileInfo::exists(path))
        return std::nullopt;
    const Result<Preset> solution = readPreset(path);
    if (solution)
        return *solution;
    lab.findings.push_back(solution.error());
    return std::nullopt;
}

void readTask(const QString &folder, const QString &language, Lab &lab)
{
    const QString path = folder + QStringLiteral("/task.json");
    const Result<QJsonObject> json = readJson(path, "task.schema.json");
    if (!json) {
        lab.findings.push_back(json.error());
        return;
    }
    const auto text = [&](const char *key) { return json->value(QLatin1String(key)).toString(); };
    const Result<Preset> preset = readPreset(folder + QLatin1Char('/') + text("preset"));
    if (!preset) {
        lab.findings.push_back(preset.error());
        return;
    }
    if (lab.indexOf(text("id")) >= 0) {
        lab.findings.push_back(
            {.message = ReaderText::tr("another step has the id %1 already; an id "
                                       "of its own is right")
                            .arg(text("id")),
             .file = path,
             .pointer = QStringLiteral("/id")});
        return;
    }
    const std::optional<Preset> solution = solutionOf(folder, lab);
    const std::size_t circles =
        std::max(preset->circles.size(), solution ? solution->circles.size() : 0);
    const std::vector<Error> faults = findCheckFaults(*json, circles, path);
    if (!faults.empty()) {
        lab.findings.insert(lab.findings.end(), faults.begin(), faults.end());
        return;
    }
    const QJsonObject words = translationOf(path, language, lab);
    Task task;
    task.id = text("id");
    task.title = words.value(QStringLiteral("title")).toString(text("title"));
    task.commit = text("commit");
    task.folder = folder;
    task.instructions = textOf(folder, language, lab);
    task.hints = stringsOf(json->value(QStringLiteral("hints")));
    const QStringList hints = stringsOf(words.value(QStringLiteral("hints")));
    if (hints.size() == task.hints.size())
        task.hints = hints;
    task.codeHints = stringsOf(json->value(QStringLiteral("code_hints")));
    const QStringList codeHints = stringsOf(words.value(QStringLiteral("code_hints")));
    if (codeHints.size() == task.codeHints.size())
        task.codeHints = codeHints;
    task.preset = *preset;
    task.checks = checksOf(*json, words.value(QStringLiteral("checks")).toObject());
    task.extra = json->value(QStringLiteral("extra")).toBool();
    task.solutionScene = solution;
    if (solution)
        task.laws = solution->laws;
    readScripts(*json, words, task, lab);
    lab.tasks.push_back(task);
}

/// SHA-256 over names and contents of all files, in order of their names.
QString hashOf(const QString &folder)
{
    QStringList files;
    QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext())
        files.append(it.next());
    files.sort();
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const QString &path : std::as_const(files)) {
        hash.addData(QDir(folder).relativeFilePath(path).toUtf8() + '\n');
        QFile file(path);
        if (file.open(QIODevice::ReadOnly))
            hash.addData(&file);
    }
    return QString::fromLatin1(hash.result().toHex());
}

} // namespace

int Lab::indexOf(const QString &taskId) const
{
    const auto found = std::find_if(tasks.begin(), tasks.end(),
                                    [&](const Task &task) { return task.id == taskId; });
    return found == tasks.end() ? -1 : static_cast<int>(found - tasks.begin());
}

Result<Lab> readLab(const QString &folder, const QString &language)
{
    const QString path = folder + QStringLiteral("/lab.json");
    const Result<QJsonObject> json = readJson(path, "lab.schema.json");
    if (!json)
        return json.error();
    Lab lab;
    const auto text = [&](const char *key) { return json->value(QLatin1String(key)).toString(); };
    lab.id = text("id");
    lab.title =
        translationOf(path, language, lab).value(QStringLiteral("title")).toString(text("title"));
    lab.version = text("version");
    lab.language = text("language");
    lab.folder = folder;
    lab.hash = hashOf(folder);
    for (const QString &step : stringsOf(json->value(QStringLiteral("steps"))))
        readTask(folder + QLatin1Char('/') + step, language, lab);
    return lab;
}

} // namespace cradle
