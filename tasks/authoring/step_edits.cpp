// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_edits.h"

#include "model/preset_json.h"
#include "tasks/authoring/json_patch.h"
#include "tasks/authoring/lab_json.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>

namespace cradle {

// Scenes, texts and programs of a step.

namespace {

struct EditText {
    Q_DECLARE_TR_FUNCTIONS(LabEdits)
};

Result<QString> presetPath(const LabFiles &files, const QString &step, StepPreset which)
{
    if (which == StepPreset::Solution)
        return solutionPresetPath(step);
    const Result<TaskForm> form = taskForm(files, step);
    if (!form)
        return form.error();
    return QString(step + QLatin1Char('/') + form->preset);
}

QJsonObject jsonFrom(const Preset &preset)
{
    return QJsonDocument::fromJson(writePreset(preset)).object();
}

QString taskPath(const QString &step)
{
    return step + QStringLiteral("/task.json");
}

/// "mistakes" or "remarks": the folder, and the key in translations.
QString folderOf(KnownKind kind)
{
    return kind == KnownKind::Mistake ? QStringLiteral("mistakes") : QStringLiteral("remarks");
}

std::optional<Error> faultOfKnown(const LabFiles &files, const QString &step, KnownKind kind,
                                  const QString &name)
{
    static const QRegularExpression right(QStringLiteral("^[A-Za-z0-9][A-Za-z0-9._-]{0,63}$"));
    const QString path = knownPath(step, kind, name);
    if (!right.match(name).hasMatch() || !faultOfLabPath(path).isEmpty())
        return Error{.message = EditText::tr("\"%1\" cannot be the name of a program; letters, "
                                             "digits, dots, dashes and underscores are right")
                                    .arg(name.left(60)),
                     .file = step};
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        if (it.key().compare(path, Qt::CaseInsensitive) == 0)
            return Error{.message = EditText::tr("the step has a program of this name already"),
                         .file = path};
    }
    return std::nullopt;
}

Error noSuchProgram(const QString &path)
{
    return {.message = EditText::tr("there is no such program"), .file = path};
}

bool isListed(const TaskForm &form, const QString &remark)
{
    return std::any_of(form.remarks.begin(), form.remarks.end(),
                       [&](const RemarkForm &known) { return known.id == remark; });
}

/// The remarks of task.json after one of them was renamed, or removed if \p newName is empty.
Result<LabFiles> withRemark(const LabFiles &files, const QString &step, const QString &name,
                            const QString &newName)
{
    Result<TaskForm> form = taskForm(files, step);
    if (!form)
        return form.error();
    for (RemarkForm &remark : form->remarks) {
        if (remark.id == name)
            remark.id = newName;
    }
    form->remarks.erase(
        std::remove_if(form->remarks.begin(), form->remarks.end(),
                       [](const RemarkForm &remark) { return remark.id.isEmpty(); }),
        form->remarks.end());
    return withTask(files, step, *form);
}

} // namespace

QString solutionPresetPath(const QString &step)
{
    return step + QStringLiteral("/solution-preset.json");
}

Result<Preset> presetOf(const LabFiles &files, const QString &step, StepPreset which)
{
    const Result<QString> path = presetPath(files, step, which);
    if (!path)
        return path.error();
    if (!files.contents.contains(*path))
        return Error{.message = EditText::tr("cannot be read: there is no such file"),
                     .file = *path};
    return parsePreset(files.contents.value(*path), *path);
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
    const Result<Preset> written = parsePreset(text, *path);
    if (!written || *written != preset)
        text = writePreset(preset);
    return withFile(files, *path, text);
}

QString textOf(const LabFiles &files, const QString &path)
{
    QString text = QString::fromUtf8(files.contents.value(path));
    if (text.startsWith(QChar::ByteOrderMark))
        text.remove(0, 1);
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

QString knownPath(const QString &step, KnownKind kind, const QString &name)
{
    return QStringLiteral("%1/%2/%3.lua").arg(step, folderOf(kind), name);
}

QStringList knownNames(const LabFiles &files, const QString &step, KnownKind kind)
{
    QStringList names;
    if (kind == KnownKind::Remark) {
        const Result<TaskForm> form = taskForm(files, step);
        for (std::size_t i = 0; form && i < form->remarks.size(); ++i)
            names.append(form->remarks[i].id);
        return names;
    }
    const QString start = QStringLiteral("%1/%2/").arg(step, folderOf(kind));
    for (auto it = files.contents.lowerBound(start);
         it != files.contents.end() && it.key().startsWith(start); ++it) {
        const QString name = it.key().mid(start.size());
        if (name.endsWith(QLatin1String(".lua")) && !name.contains(QLatin1Char('/')))
            names.append(name.chopped(4));
    }
    return names;
}

Result<LabFiles> withKnownAdded(const LabFiles &files, const QString &step, KnownKind kind,
                                const QString &name, const QString &source)
{
    if (auto fault = faultOfKnown(files, step, kind, name))
        return *fault;
    const LabFiles added = withText(files, knownPath(step, kind, name), source);
    if (kind == KnownKind::Mistake)
        return added;
    Result<TaskForm> form = taskForm(files, step);
    if (!form)
        return form.error();
    if (!isListed(*form, name))
        form->remarks.push_back({.id = name});
    return withTask(added, step, *form);
}

Result<LabFiles> withKnownRemoved(const LabFiles &files, const QString &step, KnownKind kind,
                                  const QString &name)
{
    const QString path = knownPath(step, kind, name);
    const bool isThere =
        files.contents.contains(path) || knownNames(files, step, kind).contains(name);
    if (!isThere)
        return noSuchProgram(path);
    const LabFiles removed =
        withTranslatedKey(withoutFile(files, path), step, folderOf(kind), name, {});
    return kind == KnownKind::Mistake ? removed : withRemark(removed, step, name, {});
}

Result<LabFiles> withKnownRenamed(const LabFiles &files, const QString &step, KnownKind kind,
                                  const QString &name, const QString &newName)
{
    const QString path = knownPath(step, kind, name);
    if (!files.contents.contains(path))
        return noSuchProgram(path);
    if (name == newName)
        return files;
    LabFiles moved = withoutFile(files, path);
    if (auto fault = faultOfKnown(moved, step, kind, newName))
        return *fault;
    moved.contents.insert(knownPath(step, kind, newName), files.contents.value(path));
    moved = withTranslatedKey(moved, step, folderOf(kind), name, newName);
    return kind == KnownKind::Mistake ? moved : withRemark(moved, step, name, newName);
}

QString knownText(const LabFiles &files, const QString &step, KnownKind kind, const QString &name,
                  const QString &language)
{
    const QString path = translatedPath(taskPath(step), language);
    const Result<QJsonObject> json = jsonOf(files, path, translationSchema);
    return json ? json->value(folderOf(kind)).toObject().value(name).toString() : QString();
}

Result<LabFiles> withKnownText(const LabFiles &files, const QString &step, KnownKind kind,
                               const QString &name, const QString &language, const QString &text)
{
    const QString path = translatedPath(taskPath(step), language);
    QJsonObject texts;
    if (files.contents.contains(path)) {
        const Result<QJsonObject> json = jsonOf(files, path, translationSchema);
        if (!json)
            return json.error();
        texts = json->value(folderOf(kind)).toObject();
    }
    if (text.isEmpty())
        texts.remove(name);
    else
        texts.insert(name, text);
    return withMember(files, path, translationSchema, folderOf(kind),
                      texts.isEmpty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(texts));
}

QStringList foreignFiles(const LabFiles &files, const QString &step)
{
    static const QRegularExpression known(QStringLiteral(
        "^(task(\\.[A-Za-z_]+)?\\.json|instructions(\\.[A-Za-z_]+)?\\.md|preset\\.json|"
        "solution-preset\\.json|(starter|solution)\\.lua|"
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
