// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/student_edition.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/lab_json.h"
#include "tasks/judging/asked_laws.h"
#include "tasks/lab_files/step_alone.h"
#include "tasks/reading/lab_reader.h"

#include <QJsonArray>
#include <QRegularExpression>

namespace cradle {

namespace {

const QString editionKey = QStringLiteral("edition");

/// Files beside the steps that students need, or that a licence wants to go along.
bool staysAtRoot(const QString &name)
{
    static const QRegularExpression right(
        QStringLiteral("^(lab(\\.[A-Za-z_]+)?\\.json|(LICEN[CS]E|COPYING)([.-].*)?)$"));
    return right.match(name).hasMatch();
}

/// Names of files in "checks" that the step's checks are written in.
QStringList scriptsOf(const LabFiles &files, const QString &step)
{
    QStringList names;
    const Result<TaskForm> form = taskForm(files, step);
    if (!form)
        return names;
    for (const CheckForm &check : form->checks)
        names.append(check.parameters.value(QStringLiteral("script")).toString());
    return names;
}

/// Whether a file of a step is for students.
bool isForStudents(const QString &name, const QStringList &scripts)
{
    static const QRegularExpression secret(
        QStringLiteral("^(solution\\.lua|solution-preset\\.json|(mistakes|remarks)/.*)$"));
    if (secret.match(name).hasMatch())
        return false;
    return !name.startsWith(QLatin1String("checks/")) || scripts.contains(name.mid(7));
}

LabFiles withoutSecrets(const LabFiles &files)
{
    LabFiles kept;
    const QStringList steps = stepsOf(files);
    QMap<QString, QStringList> scripts;
    QStringList foreign;
    for (const QString &step : steps) {
        scripts.insert(step, scriptsOf(files, step));
        foreign += foreignFiles(files, step);
    }
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        const auto slash = it.key().indexOf(QLatin1Char('/'));
        const QString step = it.key().left(std::max<qsizetype>(slash, 0));
        const bool stays = slash < 0
                               ? staysAtRoot(it.key())
                               : steps.contains(step) && !foreign.contains(it.key())
                                     && isForStudents(it.key().mid(slash + 1), scripts.value(step));
        if (stays)
            kept.contents.insert(it.key(), *it);
    }
    return kept;
}

/// Without members that only tell of what was left out.
Result<LabFiles> withoutMembers(const LabFiles &files, const QString &path, const char *schema,
                                std::initializer_list<const char *> names)
{
    const Result<QJsonObject> before = jsonOf(files, path, schema);
    if (!before)
        return before.error();
    QJsonObject after = *before;
    for (const char *name : names)
        after.remove(QLatin1String(name));
    return withPatch(files, path, schema, *before, after);
}

Result<LabFiles> withoutTraces(const LabFiles &kept, const QString &step)
{
    Result<LabFiles> result = withoutMembers(kept, taskPath(step), taskSchema, {"remarks"});
    for (const QString &path : translationsOf(kept, step)) {
        if (result)
            result = withoutMembers(*result, path, translationSchema, {"mistakes", "remarks"});
    }
    return result;
}

} // namespace

Result<StudentEdition> studentEdition(const LabFiles &files)
{
    Result<LabFiles> kept = withoutSecrets(files);
    for (const QString &step : stepsOf(files)) {
        if (kept)
            kept = withoutTraces(*kept, step);
    }
    // An edition of an edition is the same one.
    const Result<QJsonObject> index = jsonOf(files, indexFile, labSchema);
    if (!index)
        return index.error();
    const QString hash = index->value(editionKey).toString(hashOf(files));
    if (kept)
        kept = withMember(*kept, indexFile, labSchema, editionKey, hash);
    if (!kept)
        return kept.error();
    StudentEdition edition{.files = *kept};
    edition.left = static_cast<int>(files.contents.size() - kept->contents.size());
    const Result<Lab> lab = readLab(*kept, {});
    if (!lab)
        return lab.error();
    for (const Task &task : lab->tasks) {
        if (!askedLaws(task).motion)
            edition.unexplained.append(task.id);
    }
    return edition;
}

} // namespace cradle
