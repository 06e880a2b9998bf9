// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/task_reader.h"

#include "tasks/checks/check_validation.h"
#include "tasks/questions/question_json.h"
#include "tasks/reading/known_scripts.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

constexpr std::size_t mostCheckedCircles = 100; ///< as in task.schema.json

struct TaskReaderText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

/// Tells what keeps a translation from being shown, in whatever language the lab is read.
void findTranslationFaults(const LabSource &source, const QString &step, const QJsonObject &json,
                           const QString &language, Lab &lab)
{
    const QString start = step + QStringLiteral("/task.");
    const QMap<QString, QByteArray> &files = source.files().contents;
    for (auto it = files.lowerBound(start); it != files.end() && it.key().startsWith(start); ++it) {
        if (!it.key().endsWith(QLatin1String(".json"))
            || it.key() == start + QStringLiteral("json"))
            continue;
        const Result<QJsonObject> words = source.readJson(it.key(), "translation.schema.json");
        const QString fault = words ? translationFault(json, *words) : QString();
        if (!fault.isEmpty())
            lab.findings.push_back({.message = fault,
                                    .file = source.fullPath(it.key()),
                                    .pointer = QStringLiteral("/prediction/answers")});
        else if (!words && it.key() != start + language + QStringLiteral(".json"))
            lab.findings.push_back(words.error()); // that of the language has been told
    }
}

QString textOf(const LabSource &source, const QString &step, const QString &language, Lab &lab)
{
    const QString own = step + QStringLiteral("/instructions.md");
    const QString translated = step + QStringLiteral("/instructions.%1.md").arg(language);
    return source.readText(source.has(translated) ? translated : own, limits::labFileBytes,
                           lab.findings);
}

Mover moverOf(const QString &name)
{
    if (name == QLatin1String("program"))
        return Mover::Program;
    return name == QLatin1String("laws") ? Mover::Laws : Mover::Either;
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
std::optional<Preset> solutionOf(const LabSource &source, const QString &step, Lab &lab)
{
    const QString path = step + QStringLiteral("/solution-preset.json");
    if (!source.has(path))
        return std::nullopt;
    const Result<Preset> solution = source.readPreset(path);
    if (solution)
        return *solution;
    lab.findings.push_back(solution.error());
    return std::nullopt;
}

} // namespace

QStringList stringsOf(const QJsonValue &list)
{
    QStringList strings;
    for (const QJsonValue &value : list.toArray())
        strings.append(value.toString());
    return strings;
}

/// The texts of "NAME.LANGUAGE.json" beside "NAME.json"; empty if there are none.
QJsonObject translationOf(const LabSource &source, const QString &path, const QString &language,
                          Lab &lab)
{
    QString translated = path;
    translated.replace(QStringLiteral(".json"),
                       QLatin1Char('.') + language + QStringLiteral(".json"));
    if (!source.has(translated))
        return {};
    const Result<QJsonObject> json = source.readJson(translated, "translation.schema.json");
    if (json)
        return *json;
    lab.findings.push_back(json.error());
    return {};
}

void readTask(const LabSource &source, const QString &step, const QString &language, Lab &lab)
{
    const QString path = step + QStringLiteral("/task.json");
    const Result<QJsonObject> json = source.readJson(path, "task.schema.json");
    if (!json) {
        lab.findings.push_back(json.error());
        return;
    }
    const auto text = [&](const char *key) { return json->value(QLatin1String(key)).toString(); };
    const Result<Preset> preset = source.readPreset(step + QLatin1Char('/') + text("preset"));
    if (!preset) {
        lab.findings.push_back(preset.error());
        return;
    }
    if (lab.indexOf(text("id")) >= 0) {
        lab.findings.push_back(
            {.message = TaskReaderText::tr("another step has the id %1 already; an id "
                                           "of its own is right")
                            .arg(text("id")),
             .file = source.fullPath(path),
             .pointer = QStringLiteral("/id")});
        return;
    }
    const std::optional<Preset> solution = solutionOf(source, step, lab);
    // Those that students add are in the scene that passes, which an edition for them has not.
    const std::size_t circles =
        lab.forStudents ? mostCheckedCircles
                        : std::max(preset->circles.size(), solution ? solution->circles.size() : 0);
    std::vector<Error> faults = findCheckFaults(*json, circles, source.fullPath(path));
    for (Error fault : questionFaults(*json)) {
        fault.file = source.fullPath(path);
        faults.push_back(fault);
    }
    if (!faults.empty()) {
        lab.findings.insert(lab.findings.end(), faults.begin(), faults.end());
        return;
    }
    const QJsonObject words = translationOf(source, path, language, lab);
    Task task;
    task.id = text("id");
    task.title = words.value(QStringLiteral("title")).toString(text("title"));
    task.commit = text("commit");
    task.folder = source.fullPath(step);
    task.instructions = textOf(source, step, language, lab);
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
    for (CheckSpec &check : task.checks)
        check.language = language;
    task.moves = moverOf(text("moves"));
    task.extra = json->value(QStringLiteral("extra")).toBool();
    if (json->contains(QStringLiteral("points")))
        task.points = json->value(QStringLiteral("points")).toDouble();
    task.solutionScene = solution;
    if (solution)
        task.laws = solution->laws;
    task.forStudents = lab.forStudents;
    task.locked = stringsOf(json->value(QStringLiteral("locked")));
    task.prediction = readPrediction(*json, words);
    task.questions = readQuestions(*json, words);
    if (const QString fault = predictionFault(*json); !fault.isEmpty())
        lab.findings.push_back({.message = fault,
                                .file = source.fullPath(path),
                                .pointer = QStringLiteral("/prediction/right")});
    findTranslationFaults(source, step, *json, language, lab);
    readScripts(source, step, language, *json, words, task, lab);
    lab.tasks.push_back(task);
}

} // namespace cradle
