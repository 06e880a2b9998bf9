// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/work/student_work.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tasks/script/program_text.h"
#include "tasks/work/work_archive.h"
#include "tasks/workspace/history.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

namespace {

struct WorkText {
    Q_DECLARE_TR_FUNCTIONS(HandIn)
};

constexpr qint64 mostFileBytes = 8 * 1024 * 1024;
constexpr int mostVersions = 200; ///< of a step

QString text(const QJsonObject &json, const char *key)
{
    return json.value(QLatin1String(key)).toString();
}

StepWork stepFrom(const WorkFiles &files, const QString &id)
{
    StepWork step;
    const QString program = QStringLiteral("steps/%1.lua").arg(id);
    if (files.contains(program)) {
        const auto read = programFrom(files[program], program);
        if (read)
            step.program = *read;
        else
            step.programFault = read.error().toString();
    }
    const QString preset = QStringLiteral("presets/%1.json").arg(id);
    if (files.contains(preset)) {
        if (const auto scene = parsePreset(files[preset], preset))
            step.scene = *scene;
    }
    step.note = QString::fromUtf8(files.value(QStringLiteral("notes/%1.md").arg(id)));
    return step;
}

} // namespace

const StepWork &StudentWork::step(const QString &taskId) const
{
    static const StepWork nothing;
    const auto found = steps.find(taskId);
    return found == steps.end() ? nothing : found->second;
}

Result<WorkFiles> readWorkFiles(const QString &folder)
{
    if (!QFileInfo(folder).isDir())
        return Error{.message = WorkText::tr("this is no folder with a student's work"),
                     .file = folder};
    WorkFiles files;
    const std::pair<const char *, const char *> kinds[] = {
        {"", "lab.lua"},    {"", "cradle.json"},   {"", "predictions.json"}, {"", "answers.json"},
        {"steps", "*.lua"}, {"presets", "*.json"}, {"notes", "*.md"}};
    for (const auto &[below, pattern] : kinds) {
        const QString start = *below ? QLatin1String(below) + QLatin1Char('/') : QString();
        const QDir dir(folder + QLatin1Char('/') + QLatin1String(below));
        for (const QString &name :
             dir.entryList({QLatin1String(pattern)}, QDir::Files, QDir::Name)) {
            const auto bytes = readFile(dir.filePath(name), mostFileBytes);
            if (!bytes)
                return bytes.error();
            files.insert(start + name, *bytes);
        }
    }
    return files;
}

StudentWork workFrom(const WorkFiles &files, const Lab &lab)
{
    StudentWork work;
    const QString info = QStringLiteral("cradle.json");
    if (files.contains(info)) {
        if (const auto read = workspaceInfoFrom(files[info], info))
            work.info = *read;
    }
    const auto guesses = predictionsFrom(files.value(QStringLiteral("predictions.json")));
    const auto answers = answersFrom(files.value(QStringLiteral("answers.json")));
    for (const Task &task : lab.tasks) {
        StepWork step = stepFrom(files, task.id);
        if (const auto answer = answers.find(task.id); answer != answers.end())
            step.answers = answer->second;
        if (const auto guess = guesses.find(task.id); guess != guesses.end())
            step.guess = guess->second;
        work.steps[task.id] = std::move(step);
    }
    for (KeptProgram &kept : historyFrom(files.value(QStringLiteral("history.json")))) {
        if (const auto step = work.steps.find(kept.version.taskId); step != work.steps.end())
            step->second.versions.push_back(std::move(kept));
    }
    work.noteToTeacher = QString::fromUtf8(files.value(QStringLiteral("note-to-teacher.txt")));
    return work;
}

Result<StudentWork> readWork(const QString &path, const Lab &lab)
{
    if (isWorkArchive(path)) {
        const auto files = readWorkArchive(path);
        return files ? Result<StudentWork>(workFrom(*files, lab)) : files.error();
    }
    const auto files = readWorkFiles(path);
    if (!files)
        return files.error();
    StudentWork work = workFrom(*files, lab);
    const auto history = History::openExisting(path);
    if (!history)
        return work; // a plain folder
    for (auto &[id, step] : work.steps) {
        for (const Version &version : (*history)->versions(id, mostVersions)) {
            if (const auto bytes = (*history)->textOf(version))
                step.versions.push_back({version, QString::fromUtf8(*bytes)});
        }
    }
    return work;
}

QByteArray predictionsText(const std::map<QString, Guess> &guesses)
{
    QJsonObject json;
    for (const auto &[id, guess] : guesses) {
        if (guess == Guess{})
            continue;
        QJsonObject one{{QStringLiteral("watched"), guess.watched},
                        {QStringLiteral("revealed"), guess.revealed}};
        if (guess.answer)
            one.insert(QStringLiteral("answer"), *guess.answer);
        json.insert(id, one);
    }
    return QJsonDocument(json).toJson();
}

std::map<QString, Guess> predictionsFrom(const QByteArray &bytes)
{
    std::map<QString, Guess> guesses;
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    for (auto it = json.begin(); it != json.end(); ++it) {
        const QJsonObject one = it.value().toObject();
        Guess &guess = guesses[it.key()];
        const QJsonValue answer = one.value(QStringLiteral("answer"));
        if (answer.isDouble() && answer.toInt(-2) >= Guess::notSure)
            guess.answer = answer.toInt();
        guess.watched = one.value(QStringLiteral("watched")).toBool();
        guess.revealed = one.value(QStringLiteral("revealed")).toBool();
    }
    return guesses;
}

QByteArray historyText(const std::vector<KeptProgram> &programs)
{
    QJsonArray list;
    for (const KeptProgram &kept : programs) {
        list.append(QJsonObject{
            {QStringLiteral("commit"), kept.version.id},
            {QStringLiteral("step"), kept.version.taskId},
            {QStringLiteral("when"), kept.version.when.toString(Qt::ISODate)},
            {QStringLiteral("message"), versionMessage(kept.version.taskId, kept.version.note)},
            {QStringLiteral("program"), kept.text}});
    }
    return QJsonDocument(list).toJson();
}

std::vector<KeptProgram> historyFrom(const QByteArray &bytes)
{
    std::vector<KeptProgram> programs;
    const QJsonArray list = QJsonDocument::fromJson(bytes).array();
    for (const QJsonValue &value : list) {
        const QJsonObject one = value.toObject();
        programs.push_back({{.id = text(one, "commit").left(64),
                             .taskId = text(one, "step"),
                             .when = QDateTime::fromString(text(one, "when"), Qt::ISODate),
                             .note = versionNote(text(one, "message").left(20'000))},
                            text(one, "program")});
        if (programs.size() >= 10'000)
            break;
    }
    return programs;
}

} // namespace cradle
