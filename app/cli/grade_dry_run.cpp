// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_class.h"

#include "tasks/grading/handed_in.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle::cli {

namespace {

struct DryRunText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// What of a student's files would be judged.
QStringList workOf(const HandedIn &handedIn)
{
    if (!handedIn.request.archive.isEmpty())
        return {QStringLiteral(".cradle-work")};
    return handedIn.request.files.keys();
}

QJsonObject jsonOf(const FoundStudent &student, const HandedIn &handedIn)
{
    return {{QStringLiteral("id"), student.id},
            {QStringLiteral("name"), student.name},
            {QStringLiteral("number"), student.number},
            {QStringLiteral("email"), student.email},
            {QStringLiteral("late_days"), student.lateDays},
            {QStringLiteral("how"), student.how},
            {QStringLiteral("files"), QJsonArray::fromStringList(workOf(handedIn))},
            {QStringLiteral("remark"), handedIn.remark}};
}

/// Programs by their number; everything else by name.
QString shortText(const QStringList &work)
{
    QStringList others;
    int programs = 0;
    for (const QString &file : work) {
        if (file.startsWith(QLatin1String("steps/")))
            ++programs;
        else
            others.append(file);
    }
    if (programs > 0)
        others.prepend(DryRunText::tr("programs: %1").arg(programs));
    return others.isEmpty() ? DryRunText::tr("nothing to judge") : spokenList(others);
}

QByteArray jsonOf(const ClassFolder &found, const QJsonArray &students)
{
    QJsonArray missing;
    for (const MissingStudent &each : found.missing)
        missing.append(QJsonObject{{QStringLiteral("id"), each.id},
                                   {QStringLiteral("name"), each.name},
                                   {QStringLiteral("number"), each.number},
                                   {QStringLiteral("email"), each.email}});
    return QJsonDocument(
               QJsonObject{{QStringLiteral("students"), students},
                           {QStringLiteral("missing"), missing},
                           {QStringLiteral("remarks"), QJsonArray::fromStringList(found.remarks)}})
        .toJson();
}

} // namespace

ExitCode tellClass(const GradeRequest &request, const Lab &lab, const ClassFolder &found)
{
    QJsonArray students;
    QString text;
    for (const FoundStudent &student :
         shardOf(found.students, request.shard.index, request.shard.count)) {
        const HandedIn handedIn = readHandedIn(student, found.root, lab);
        students.append(jsonOf(student, handedIn));
        text += QStringLiteral("%1  %2 (%3): %4")
                    .arg(student.id, -16)
                    .arg(student.name, student.how, shortText(workOf(handedIn)));
        if (!handedIn.remark.isEmpty())
            text += QStringLiteral("; ") + handedIn.remark;
        text += QLatin1Char('\n');
    }
    for (const MissingStudent &each : found.missing)
        text += DryRunText::tr("missing: %1 %2").arg(each.id, each.name) + QLatin1Char('\n');
    for (const QString &remark : found.remarks)
        text += remark + QLatin1Char('\n');
    text += DryRunText::tr("students: %1").arg(students.size()) + QLatin1Char('\n');
    const auto error = writeText({}, request.events ? jsonOf(found, students) : text.toUtf8());
    return error ? complainUnwritten(*error) : Done;
}

} // namespace cradle::cli
