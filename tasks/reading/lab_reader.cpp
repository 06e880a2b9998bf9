// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_reader.h"

#include "tasks/lab_files/step_alone.h"
#include "tasks/reading/task_reader.h"
#include "tasks/values/lab_values.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace cradle {

namespace {

struct LabReaderText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

/// Reads the steps that lab.json lists, each once.
void readTasks(const LabSource &source, const QJsonObject &json, const QString &language, Lab &lab)
{
    const QStringList steps = stringsOf(json.value(QStringLiteral("steps")));
    for (qsizetype i = 0; i < steps.size(); ++i) {
        if (steps.indexOf(steps[i]) == i)
            readTask(source, steps[i], language, lab);
        else
            lab.findings.push_back({.message = LabReaderText::tr("the step %1 is listed already; "
                                                                 "each step once is right")
                                                   .arg(steps[i]),
                                    .file = source.fullPath(QStringLiteral("lab.json")),
                                    .pointer = QStringLiteral("/steps/%1").arg(i)});
    }
}

Result<Lab> readFrom(const LabSource &source, const QString &folder, const QString &language)
{
    const QString path = QStringLiteral("lab.json");
    const Result<QJsonObject> json = source.readJson(path, "lab.schema.json");
    if (!json)
        return json.error();
    Lab lab;
    const auto text = [&](const char *key) { return json->value(QLatin1String(key)).toString(); };
    lab.id = text("id");
    lab.title = translationOf(source, path, language, lab)
                    .value(QStringLiteral("title"))
                    .toString(text("title"));
    lab.version = text("version");
    lab.language = text("language");
    lab.folder = folder;
    lab.hash = text("edition");
    lab.forStudents = !lab.hash.isEmpty();
    readTasks(source, *json, language, lab);
    for (const Error &fault : source.untold(lab.findings))
        lab.findings.push_back(fault);
    return lab;
}

/// Reads what \p files become with their values.
Result<Lab> readWithValues(const LabFiles &files, const QString &folder, const QString &language,
                           const QString &student, std::vector<Error> faults)
{
    std::vector<Error> found;
    const LabFiles put = withValues(files, student, &found);
    const QStringList unlisted = unlistedSteps(files);
    for (Error &fault : found) {
        if (unlisted.contains(fault.file.section(QLatin1Char('/'), 0, 0)))
            continue; // what is no step of the lab is nobody's concern
        fault.file = folder + QLatin1Char('/') + fault.file;
        faults.push_back(std::move(fault));
    }
    Result<Lab> lab = readFrom(LabSource(put, folder, std::move(faults)), folder, language);
    if (!lab)
        return lab;
    if (!lab->forStudents)
        lab->hash = hashOf(files);
    lab->files = std::make_shared<const LabFiles>(files);
    lab->readIn = language;
    lab->drawsValues = drawsValues(files);
    return lab;
}

/// The step alone, if that is asked for and it can be found so; else all.
Result<ReadLab> readStep(LabFiles files, const QString &folder, const QString &language,
                         const QString &step, std::vector<Error> faults)
{
    if (!step.isEmpty()) {
        LabFiles alone = stepAlone(files, step);
        auto lab = readWithValues(alone, folder, language, {}, faults);
        if (lab && lab->indexOf(step) >= 0) {
            if (!lab->forStudents)
                lab->hash = hashOf(files);
            return ReadLab{std::move(alone), std::move(*lab)};
        }
    }
    auto lab = readWithValues(files, folder, language, {}, std::move(faults));
    if (!lab)
        return lab.error();
    return ReadLab{std::move(files), std::move(*lab)};
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
    auto read = readLabWithFiles(folder, language);
    return read ? Result<Lab>(std::move(read->lab)) : Result<Lab>(read.error());
}

Result<ReadLab> readLabWithFiles(const QString &folder, const QString &language,
                                 const QString &step)
{
    std::vector<Error> faults;
    LabFiles files;
    // What is no lab may be a whole disk: then nothing else is read.
    const QFileInfo index(folder + QStringLiteral("/lab.json"));
    if (!QFileInfo(folder).isDir() || index.exists() || index.isSymLink()) {
        auto there = readLabFiles(folder, &faults);
        if (!there) {
            Error error = there.error();
            error.file += QStringLiteral("/lab.json");
            return error;
        }
        files = std::move(*there);
    }
    return readStep(std::move(files), folder, language, step, std::move(faults));
}

Result<ReadLab> readLabWithFiles(LabFiles files, const QString &folder, const QString &language,
                                 const QString &step)
{
    return readStep(std::move(files), folder, language, step, {});
}

Result<Lab> readLab(const LabFiles &files, const QString &folder, const QString &language,
                    const QString &student)
{
    return readWithValues(files, folder, language, student, {});
}

Lab forStudent(const Lab &lab, const QString &student)
{
    if (!lab.drawsValues)
        return lab;
    const Result<Lab> own = readLab(*lab.files, lab.folder, lab.readIn, student);
    return own ? *own : lab;
}

} // namespace cradle
