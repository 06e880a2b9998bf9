// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/known_scripts.h"

#include "tasks/script/check_script.h"
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

KnownScript readKnown(const LabSource &source, const QString &path, const QJsonObject &texts,
                      Lab &lab)
{
    KnownScript known;
    known.name = path.section(QLatin1Char('/'), -1).chopped(4);
    known.source = readProgram(source, path, lab);
    known.message = texts.value(known.name).toString(firstCommentBlock(known.source));
    if (known.message.isEmpty())
        lab.findings.push_back(
            {.message = ReaderText::tr("the program begins without a comment; what the student "
                                       "should read of it stands there"),
             .file = source.fullPath(path),
             .line = 1});
    return known;
}

/// The programs in a folder, in order of their names.
QStringList programsIn(const LabSource &source, const QString &folder)
{
    const auto &files = source.files().contents;
    QStringList paths;
    for (auto it = files.lowerBound(folder); it != files.end() && it.key().startsWith(folder);
         ++it) {
        if (it.key().endsWith(QLatin1String(".lua"))
            && it.key().indexOf(QLatin1Char('/'), folder.size()) < 0)
            paths.append(it.key());
    }
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
        RemarkSpec remark;
        remark.script =
            readKnown(source, QStringLiteral("%1/remarks/%2.lua").arg(step, text("id").toString()),
                      texts, lab);
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

QString firstCommentBlock(const QString &source)
{
    QStringList lines;
    for (QString line : source.split(QLatin1Char('\n'))) {
        if (!line.startsWith(QLatin1String("--")))
            break;
        line.remove(0, 2);
        lines.append(line.startsWith(QLatin1Char(' ')) ? line.mid(1) : line);
    }
    return lines.join(QLatin1Char('\n')).trimmed();
}

void readScripts(const LabSource &source, const QString &step, const QJsonObject &json,
                 const QJsonObject &words, Task &task, Lab &lab)
{
    task.solution = readIfThere(source, step + QStringLiteral("/solution.lua"), lab);
    task.starter = readIfThere(source, step + QStringLiteral("/starter.lua"), lab);
    if (task.starter.isEmpty() && !lab.tasks.empty())
        task.starter = lab.tasks.back().solution;
    const QJsonObject texts = words.value(QStringLiteral("mistakes")).toObject();
    for (const QString &path : programsIn(source, step + QStringLiteral("/mistakes/")))
        task.mistakes.push_back(readKnown(source, path, texts, lab));
    readCheckScripts(source, step, task, lab);
    readRemarks(source, step, json, words.value(QStringLiteral("remarks")).toObject(), task, lab);
}

} // namespace cradle
