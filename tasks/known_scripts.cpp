// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/known_scripts.h"

#include "model/json_schema.h"
#include "tasks/script/check_script.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QStringDecoder>

namespace cradle {

namespace {

struct ReaderText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

QString readProgram(const QString &path, Lab &lab)
{
    const Result<QByteArray> text = readFile(path, limits::sourceBytes);
    if (!text) {
        lab.findings.push_back(text.error());
        return {};
    }
    QStringDecoder decode(QStringDecoder::Utf8);
    QString decoded = decode(*text);
    if (decode.hasError())
        lab.findings.push_back({.message = ReaderText::tr("the text is not in UTF-8, which would "
                                                          "be right; some letters are lost"),
                                .file = path});
    return decoded;
}

QString readIfThere(const QString &path, Lab &lab)
{
    return QFile::exists(path) ? readProgram(path, lab) : QString();
}

KnownScript readKnown(const QString &path, const QJsonObject &texts, Lab &lab)
{
    KnownScript known;
    known.name = QFileInfo(path).completeBaseName();
    known.source = readProgram(path, lab);
    known.message = texts.value(known.name).toString(firstCommentBlock(known.source));
    if (known.message.isEmpty())
        lab.findings.push_back(
            {.message = ReaderText::tr("the program begins without a comment; what the student "
                                       "should read of it stands there"),
             .file = path,
             .line = 1});
    return known;
}

RemarkSpec::Compare compareFromName(const QString &name)
{
    if (name == QLatin1String("positions"))
        return RemarkSpec::Compare::Positions;
    return name == QLatin1String("fields") ? RemarkSpec::Compare::Fields
                                           : RemarkSpec::Compare::Velocities;
}

void readRemarks(const QJsonObject &json, const QJsonObject &texts, Task &task, Lab &lab)
{
    for (const QJsonValue &value : json.value(QStringLiteral("remarks")).toArray()) {
        const QJsonObject object = value.toObject();
        const auto text = [&](const char *key) { return object.value(QLatin1String(key)); };
        RemarkSpec remark;
        remark.script = readKnown(
            task.folder + QStringLiteral("/remarks/%1.lua").arg(text("id").toString()), texts, lab);
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
void readCheckScripts(Task &task, Lab &lab)
{
    for (CheckSpec &check : task.checks) {
        if (check.kind != QLatin1String("script"))
            continue;
        const QString path = task.folder + QStringLiteral("/checks/")
                             + check.parameters.value(QStringLiteral("script")).toString();
        check.source = readProgram(path, lab);
        if (const auto error = findCheckScriptError(check.source))
            lab.findings.push_back({.message = error->message, .file = path, .line = error->line});
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

void readScripts(const QJsonObject &json, const QJsonObject &words, Task &task, Lab &lab)
{
    task.solution = readIfThere(task.folder + QStringLiteral("/solution.lua"), lab);
    task.starter = readIfThere(task.folder + QStringLiteral("/starter.lua"), lab);
    if (task.starter.isEmpty() && !lab.tasks.empty())
        task.starter = lab.tasks.back().solution;
    const QDir mistakes(task.folder + QStringLiteral("/mistakes"));
    const QJsonObject texts = words.value(QStringLiteral("mistakes")).toObject();
    for (const QString &file :
         mistakes.entryList({QStringLiteral("*.lua")}, QDir::Files, QDir::Name))
        task.mistakes.push_back(readKnown(mistakes.filePath(file), texts, lab));
    readCheckScripts(task, lab);
    readRemarks(json, words.value(QStringLiteral("remarks")).toObject(), task, lab);
}

} // namespace cradle
