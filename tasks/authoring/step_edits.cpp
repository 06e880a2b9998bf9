// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_edits.h"

#include "model/files/preset_json.h"
#include "tasks/authoring/json_patch.h"
#include "tasks/authoring/lab_json.h"
#include "tasks/values/put_values.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QRegularExpression>

namespace cradle {

// Scenes, texts and programs of a step.

namespace {

struct StepEditText {
    Q_DECLARE_TR_FUNCTIONS(LabEdits)
};

QJsonObject jsonFrom(const Preset &preset)
{
    return QJsonDocument::fromJson(writePreset(preset)).object();
}

/// A scene whose numbers may be expressions.
Result<Preset> sceneFrom(const QByteArray &text, const QString &path, const Values &values)
{
    const QJsonObject json = QJsonDocument::fromJson(text).object();
    Result<QJsonObject> scene = sceneWithNumbers(json, values);
    if (!scene) {
        Error error = scene.error();
        error.file = path;
        return error;
    }
    return parsePreset(*scene == json ? text : QJsonDocument(*scene).toJson(), path);
}

} // namespace

QString solutionPresetPath(const QString &step)
{
    return step + QStringLiteral("/solution-preset.json");
}

Result<QString> presetPath(const LabFiles &files, const QString &step, StepPreset which)
{
    if (which == StepPreset::Solution)
        return solutionPresetPath(step);
    const Result<TaskForm> form = taskForm(files, step);
    if (!form)
        return form.error();
    return QString(step + QLatin1Char('/') + form->preset);
}

Result<Preset> presetOf(const LabFiles &files, const QString &step, StepPreset which)
{
    const Result<QString> path = presetPath(files, step, which);
    if (!path)
        return path.error();
    if (!files.contents.contains(*path))
        return Error{.message = StepEditText::tr("cannot be read: there is no such file"),
                     .file = *path};
    return sceneFrom(files.contents.value(*path), *path, valuesOf(files, step, {}));
}

Result<LabFiles> withPreset(const LabFiles &files, const QString &step, const Preset &preset,
                            StepPreset which)
{
    const Result<QString> path = presetPath(files, step, which);
    if (!path)
        return path.error();
    if (std::optional<Error> fault = findFault(preset)) {
        fault->file = *path;
        return *fault;
    }
    const Result<Preset> before = presetOf(files, step, which);
    if (before && *before == preset)
        return files;
    QByteArray text;
    if (before)
        text = patchJson(files.contents.value(*path), jsonFrom(*before), jsonFrom(preset));
    // A name that a file leaves out goes by the circle's place, which an edit may change.
    const Result<Preset> written = sceneFrom(text, *path, valuesOf(files, step, {}));
    if (!written || *written != preset)
        text = writePreset(preset);
    return withFile(files, *path, text);
}

QString textOf(const LabFiles &files, const QString &path)
{
    // A byte order mark is left out by fromUtf8().
    QString text = QString::fromUtf8(files.contents.value(path));
    return text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
}

LabFiles withText(const LabFiles &files, const QString &path, const QString &text)
{
    if (files.contents.contains(path) && textOf(files, path) == text)
        return files;
    return withFile(files, path, text.toUtf8());
}

LabFiles withFile(const LabFiles &files, const QString &path, const QByteArray &content)
{
    LabFiles result = files;
    result.contents.insert(path, content);
    return result;
}

LabFiles withoutFile(const LabFiles &files, const QString &path)
{
    LabFiles result = files;
    result.contents.remove(path);
    return result;
}

QString instructionsPath(const LabFiles &files, const QString &step, const QString &language)
{
    return isTranslation(files, language)
               ? QStringLiteral("%1/instructions.%2.md").arg(step, language)
               : step + QStringLiteral("/instructions.md");
}

QStringList foreignFiles(const LabFiles &files, const QString &step)
{
    static const QRegularExpression known(QStringLiteral(
        "^(task(\\.[A-Za-z_]+)?\\.json|instructions(\\.[A-Za-z_]+)?\\.md|preset\\.json|"
        "solution-preset\\.json|starter(\\.[A-Za-z_]+)?\\.lua|solution\\.lua|"
        "(mistakes|remarks|checks)/[^/]+\\.(lua|diff))$"));
    const QString start = step + QLatin1Char('/');
    QStringList names;
    QString texts;
    for (auto it = files.contents.lowerBound(start);
         it != files.contents.end() && it.key().startsWith(start); ++it) {
        const QString name = it.key().mid(start.size());
        if (!known.match(name).hasMatch())
            names.append(name);
        else if (name.endsWith(QLatin1String(".md")) || name.endsWith(QLatin1String(".json")))
            texts += QString::fromUtf8(*it);
    }
    QStringList foreign;
    for (const QString &name : std::as_const(names)) {
        if (!texts.contains(name))
            foreign.append(start + name);
    }
    return foreign;
}

} // namespace cradle
