// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/known_scripts.h"

#include "tasks/checks/check_script.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QJsonArray>

namespace cradle {

namespace {

struct ReaderText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

QString readProgram(const LabSource &source, const QString &path, Lab &lab)
{
    return source.readText(path, limits::sourceBytes, lab.findings);
}

QString readIfThere(const LabSource &source, const QString &path, Lab &lab)
{
    return source.has(path) ? readProgram(source, path, lab) : QString();
}

/// A program that is kept whole in \p path, or beside it as its difference from the solution.
/// \return nullopt if that difference does not apply, which has been told then
std::optional<QString> readWholeOrDiff(const LabSource &source, const QString &path,
                                       const QString &solution, Lab &lab)
{
    const QString diffPath = diffPathOf(path);
    if (!source.has(diffPath))
        return readProgram(source, path, lab);
    if (source.has(path))
        lab.findings.push_back({.message = ReaderText::tr("the program is there whole, too; one "
                                                          "of the two files is right"),
                                .file = source.fullPath(diffPath)});
    const Result<QString> program = programFromDiff(readProgram(source, diffPath, lab), solution);
    if (program)
        return *program;
    Error error = program.error();
    error.file = source.fullPath(diffPath);
    lab.findings.push_back(error);
    return std::nullopt;
}

std::optional<KnownScript> readKnown(const LabSource &source, const QString &path,
                                     const QString &solution, const QJsonObject &texts, Lab &lab)
{
    const std::optional<QString> program = readWholeOrDiff(source, path, solution, lab);
    if (!program)
        return std::nullopt;
    KnownScript known{path.section(QLatin1Char('/'), -1).chopped(4), *program, {}};
    known.message = texts.value(known.name).toString(firstCommentBlock(known.source));
    if (known.message.isEmpty())
        lab.findings.push_back(
            {.message = ReaderText::tr("the program begins without a comment; what the student "
                                       "should read of it stands there"),
             .file = source.fullPath(source.has(diffPathOf(path)) ? diffPathOf(path) : path),
             .line = 1});
    return known;
}

/// The programs in a folder, in order of their names: "FOLDER/NAME.lua", also those that are kept
/// as differences.
QStringList programsIn(const LabSource &source, const QString &folder)
{
    const auto &files = source.files().contents;
    QStringList paths;
    for (auto it = files.lowerBound(folder); it != files.end() && it.key().startsWith(folder);
         ++it) {
        const bool isDiff = it.key().endsWith(QLatin1String(".diff"));
        if ((isDiff || it.key().endsWith(QLatin1String(".lua")))
            && it.key().indexOf(QLatin1Char('/'), folder.size()) < 0)
            paths.append(isDiff ? it.key().chopped(5) + QStringLiteral(".lua") : it.key());
    }
    paths.sort();
    paths.removeDuplicates();
    return paths;
}

RemarkSpec::Compare compareFromName(const QString &name)
{
    if (name == QLatin1String("positions"))
        return RemarkSpec::Compare::Positions;
    return name == QLatin1String("fields") ? RemarkSpec::Compare::Fields
                                           : RemarkSpec::Compare::Velocities;
}

void readRemarks(const LabSource &source, const QString &step, const QJsonObject &json,
                 const QJsonObject &texts, Task &task, Lab &lab)
{
    for (const QJsonValue &value : json.value(QStringLiteral("remarks")).toArray()) {
        const QJsonObject object = value.toObject();
        const auto text = [&](const char *key) { return object.value(QLatin1String(key)); };
        const std::optional<KnownScript> script =
            readKnown(source, QStringLiteral("%1/remarks/%2.lua").arg(step, text("id").toString()),
                      task.solution, texts, lab);
        if (!script)
            continue;
        RemarkSpec remark{.script = *script};
        remark.compare = compareFromName(text("compare").toString());
        remark.scene = text("scene").toObject();
        const QJsonArray circles = text("circles").toArray();
        if (!circles.isEmpty())
            remark.circles.clear();
        for (const QJsonValue &circle : circles)
            remark.circles.push_back(circle.toInt() - 1);
        task.remarks.push_back(remark);
    }
}

/// The programs of the checks that are written in Lua.
void readCheckScripts(const LabSource &source, const QString &step, Task &task, Lab &lab)
{
    for (CheckSpec &check : task.checks) {
        if (check.kind != QLatin1String("script"))
            continue;
        const QString path = step + QStringLiteral("/checks/")
                             + check.parameters.value(QStringLiteral("script")).toString();
        check.source = readProgram(source, path, lab);
        if (const auto error = findCheckScriptError(check.source))
            lab.findings.push_back(
                {.message = error->message, .file = source.fullPath(path), .line = error->line});
    }
}

} // namespace

void readScripts(const LabSource &source, const QString &step, const QString &language,
                 const QJsonObject &json, const QJsonObject &words, Task &task, Lab &lab)
{
    task.solution = readIfThere(source, step + QStringLiteral("/solution.lua"), lab);
    const QString translated = QStringLiteral("%1/starter.%2.lua").arg(step, language);
    task.starter = readIfThere(
        source, source.has(translated) ? translated : step + QStringLiteral("/starter.lua"), lab);
    if (task.starter.isEmpty() && !lab.tasks.empty())
        task.starter = lab.forStudents ? lab.tasks.back().starter : lab.tasks.back().solution;
    const QJsonObject texts = words.value(QStringLiteral("mistakes")).toObject();
    for (const QString &path : programsIn(source, step + QStringLiteral("/mistakes/"))) {
        if (const auto known = readKnown(source, path, task.solution, texts, lab))
            task.mistakes.push_back(*known);
    }
    readCheckScripts(source, step, task, lab);
    readRemarks(source, step, json, words.value(QStringLiteral("remarks")).toObject(), task, lab);
}

} // namespace cradle
