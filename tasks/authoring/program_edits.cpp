// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_edits.h"

#include "tasks/authoring/lab_json.h"
#include "tasks/text/program_diff.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

struct ProgramEditText {
    Q_DECLARE_TR_FUNCTIONS(LabEdits)
};

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
        return Error{.message =
                         ProgramEditText::tr("\"%1\" cannot be the name of a program; letters, "
                                             "digits, dots, dashes and underscores are right")
                             .arg(name.left(60)),
                     .file = step};
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        if (it.key().compare(path, Qt::CaseInsensitive) == 0
            || it.key().compare(diffPathOf(path), Qt::CaseInsensitive) == 0)
            return Error{.message =
                             ProgramEditText::tr("the step has a program of this name already"),
                         .file = path};
    }
    return std::nullopt;
}

/// Of the step that the program \p path, "STEP/mistakes/NAME.lua", belongs to.
QString solutionPathOf(const QString &path)
{
    return path.section(QLatin1Char('/'), 0, 0) + QStringLiteral("/solution.lua");
}

LabFiles withDiffOf(const LabFiles &files, const QString &path, const QString &program)
{
    return withText(files, diffPathOf(path),
                    diffOfProgram(program, textOf(files, solutionPathOf(path)),
                                  path.section(QLatin1Char('/'), 1)));
}

Error noSuchProgram(const QString &path)
{
    return {.message = ProgramEditText::tr("there is no such program"), .file = path};
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

QString knownPath(const QString &step, KnownKind kind, const QString &name)
{
    return QStringLiteral("%1/%2/%3.lua").arg(step, folderOf(kind), name);
}

bool isDiff(const LabFiles &files, const QString &path)
{
    return path.endsWith(QLatin1String(".lua")) && files.contents.contains(diffPathOf(path));
}

Result<QString> programText(const LabFiles &files, const QString &path)
{
    if (!isDiff(files, path))
        return textOf(files, path);
    const Result<QString> program =
        programFromDiff(textOf(files, diffPathOf(path)), textOf(files, solutionPathOf(path)));
    if (program)
        return *program;
    Error error = program.error();
    error.file = diffPathOf(path);
    return error;
}

LabFiles withProgramText(const LabFiles &files, const QString &path, const QString &text)
{
    if (!isDiff(files, path))
        return withText(files, path, text);
    const Result<QString> before = programText(files, path);
    return before && *before == text ? files : withDiffOf(files, path, text);
}

LabFiles withDifferences(const LabFiles &files)
{
    LabFiles result = files;
    for (const QString &step : stepsOf(files)) {
        for (const KnownKind kind : {KnownKind::Mistake, KnownKind::Remark}) {
            for (const QString &name : knownNames(files, step, kind)) {
                const QString path = knownPath(step, kind, name);
                const Result<QString> kept = programText(files, path);
                const QString solution = textOf(files, solutionPathOf(path));
                if (!kept)
                    continue;
                const QString program = withCommentOf(solution, *kept);
                const LabFiles turned = withDiffOf(withoutFile(files, path), path, program);
                const Result<QString> again = programText(turned, path);
                // With blanks at odd places it stays what its author wrote.
                if (!isWorthADiff(program, solution) || !again || *again != program)
                    continue;
                result.contents.remove(path);
                result.contents.insert(diffPathOf(path), turned.contents.value(diffPathOf(path)));
            }
        }
    }
    return result;
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
        if (name.contains(QLatin1Char('/')))
            continue;
        if (name.endsWith(QLatin1String(".lua")))
            names.append(name.chopped(4));
        else if (name.endsWith(QLatin1String(".diff")))
            names.append(name.chopped(5));
    }
    names.sort();
    names.removeDuplicates();
    return names;
}

Result<LabFiles> withKnownAdded(const LabFiles &files, const QString &step, KnownKind kind,
                                const QString &name, const QString &source)
{
    if (auto fault = faultOfKnown(files, step, kind, name))
        return *fault;
    const QString path = knownPath(step, kind, name);
    const QString solution = textOf(files, solutionPathOf(path));
    const LabFiles added = isWorthADiff(source, solution) ? withDiffOf(files, path, source)
                                                          : withText(files, path, source);
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
    const LabFiles removed = withTranslatedKey(
        withoutFile(withoutFile(files, path), diffPathOf(path)), step, folderOf(kind), name, {});
    return kind == KnownKind::Mistake ? removed : withRemark(removed, step, name, {});
}

Result<LabFiles> withKnownRenamed(const LabFiles &files, const QString &step, KnownKind kind,
                                  const QString &name, const QString &newName)
{
    const QString path = knownPath(step, kind, name);
    const QString newPath = knownPath(step, kind, newName);
    const bool isDiff = files.contents.contains(diffPathOf(path));
    if (!isDiff && !files.contents.contains(path))
        return noSuchProgram(path);
    if (name == newName)
        return files;
    LabFiles moved = withoutFile(withoutFile(files, path), diffPathOf(path));
    if (auto fault = faultOfKnown(moved, step, kind, newName))
        return *fault;
    if (isDiff)
        moved.contents.insert(diffPathOf(newPath), files.contents.value(diffPathOf(path)));
    if (const Result<QString> program = programText(files, path); isDiff && program)
        moved = withDiffOf(moved, newPath, *program); // it names the file
    if (files.contents.contains(path))
        moved.contents.insert(newPath, files.contents.value(path));
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

} // namespace cradle
