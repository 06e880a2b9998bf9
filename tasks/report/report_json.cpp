// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_json.h"

#include "tasks/report/report_text.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace cradle {

namespace {

QJsonValue numberOrNull(const std::optional<double> &value)
{
    return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

/// \param scored  whether checks are worth different points
QJsonObject jsonOf(const CheckOutcome &check, bool scored)
{
    QJsonObject json{{QStringLiteral("id"), check.id},
                     {QStringLiteral("title"), check.title},
                     {QStringLiteral("passed"), check.passed},
                     {QStringLiteral("message"), check.message},
                     {QStringLiteral("expected"), numberOrNull(check.expected)},
                     {QStringLiteral("observed"), numberOrNull(check.observed)},
                     {QStringLiteral("unit"), check.unit},
                     {QStringLiteral("step"),
                      check.step >= 0 ? QJsonValue(check.step) : QJsonValue(QJsonValue::Null)},
                     {QStringLiteral("variant"), check.variant},
                     {QStringLiteral("line"),
                      check.line > 0 ? QJsonValue(check.line) : QJsonValue(QJsonValue::Null)}};
    if (scored)
        json.insert(QStringLiteral("points"), check.points);
    if (check.question)
        json.insert(QStringLiteral("question"), true);
    if (check.forTeacher)
        json.insert(QStringLiteral("for_teacher"), true);
    return json;
}

QJsonValue mistakeOf(const Finding &finding)
{
    return finding.mistake.isEmpty() ? QJsonValue(QJsonValue::Null) : QJsonValue(finding.mistake);
}

QJsonValue jsonOf(const Finding *diagnosis)
{
    if (!diagnosis)
        return QJsonValue::Null;
    return QJsonObject{{QStringLiteral("mistake"), mistakeOf(*diagnosis)},
                       {QStringLiteral("message"), diagnosis->message}};
}

QJsonArray jsonOf(const std::vector<Finding> &findings)
{
    QJsonArray array;
    for (const Finding &finding : findings) {
        QJsonArray calls;
        for (const int line : finding.calls)
            calls.append(line);
        array.append(
            QJsonObject{{QStringLiteral("aspect"), aspectName(finding.aspect)},
                        {QStringLiteral("mistake"), mistakeOf(finding)},
                        {QStringLiteral("message"), finding.message},
                        {QStringLiteral("check"), finding.check},
                        {QStringLiteral("line"), finding.line > 0 ? QJsonValue(finding.line)
                                                                  : QJsonValue(QJsonValue::Null)},
                        {QStringLiteral("calls"), calls}});
    }
    return array;
}

QJsonArray jsonOf(const std::vector<Remark> &remarks)
{
    QJsonArray array;
    for (const Remark &remark : remarks)
        array.append(QJsonObject{{QStringLiteral("id"), remark.id},
                                 {QStringLiteral("message"), remark.message}});
    return array;
}

QJsonValue jsonOf(const std::optional<ProgramError> &error)
{
    if (!error)
        return QJsonValue::Null;
    return QJsonObject{{QStringLiteral("message"), error->message},
                       {QStringLiteral("line"), error->line},
                       {QStringLiteral("step"), error->step},
                       {QStringLiteral("kind"), kindName(error->kind)}};
}

} // namespace

QString aspectName(Aspect aspect)
{
    switch (aspect) {
    case Aspect::Start:
        return QStringLiteral("start");
    case Aspect::Motion:
        return QStringLiteral("motion");
    case Aspect::Walls:
        return QStringLiteral("walls");
    case Aspect::Contact:
        return QStringLiteral("contact");
    case Aspect::Response:
        return QStringLiteral("response");
    case Aspect::Course:
        break;
    }
    return QStringLiteral("course");
}

std::optional<Aspect> aspectFromName(const QString &name)
{
    for (const Aspect aspect : {Aspect::Start, Aspect::Motion, Aspect::Walls, Aspect::Contact,
                                Aspect::Response, Aspect::Course}) {
        if (aspectName(aspect) == name)
            return aspect;
    }
    return std::nullopt;
}

QByteArray writeReport(const CheckReport &report)
{
    QJsonObject json = reportObject(report);
    json.insert(QStringLiteral("format"), 1);
    json.insert(QStringLiteral("elapsed_ms"), report.elapsedMs);
    return QJsonDocument(json).toJson();
}

QJsonObject reportObject(const CheckReport &report)
{
    QJsonArray checks;
    for (const CheckOutcome &check : report.checks)
        checks.append(jsonOf(check, isScored(report)));
    QJsonObject json{{QStringLiteral("lab"), report.labId},
                     {QStringLiteral("lab_hash"), report.labHash},
                     {QStringLiteral("task"), report.taskId},
                     {QStringLiteral("seed"), report.seed},
                     {QStringLiteral("passed"), report.passed},
                     {QStringLiteral("moved_by"),
                      report.byProgram ? QStringLiteral("program") : QStringLiteral("laws")},
                     {QStringLiteral("commit"), report.commit},
                     {QStringLiteral("checks"), checks},
                     {QStringLiteral("diagnosis"), jsonOf(report.diagnosis())},
                     {QStringLiteral("findings"), jsonOf(report.findings)},
                     {QStringLiteral("remarks"), jsonOf(report.remarks)},
                     {QStringLiteral("error"), jsonOf(report.error)}};
    if (isScored(report)) {
        json.insert(QStringLiteral("score"), scoreOf(report));
        json.insert(QStringLiteral("max_score"), fullScoreOf(report));
    }
    return json;
}

} // namespace cradle
