// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

namespace {

struct ReportText {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

QJsonValue numberOrNull(const std::optional<double> &value)
{
    return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

QString kindName(ProgramError::Kind kind)
{
    switch (kind) {
    case ProgramError::Kind::Syntax:
        return QStringLiteral("syntax");
    case ProgramError::Kind::Time:
        return QStringLiteral("time");
    case ProgramError::Kind::Memory:
        return QStringLiteral("memory");
    case ProgramError::Kind::Runtime:
        break;
    }
    return QStringLiteral("runtime");
}

QJsonObject jsonOf(const CheckOutcome &check)
{
    return {{QStringLiteral("id"), check.id},
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
}

QJsonValue jsonOf(const std::optional<Diagnosis> &diagnosis)
{
    if (!diagnosis)
        return QJsonValue::Null;
    return QJsonObject{{QStringLiteral("mistake"), diagnosis->mistake},
                       {QStringLiteral("message"), diagnosis->message}};
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

static QString indented(const QString &text)
{
    return QStringLiteral("  ") + QString(text).replace(QLatin1Char('\n'), QLatin1String("\n  "))
           + QLatin1Char('\n');
}

QByteArray writeReport(const CheckReport &report)
{
    QJsonArray checks;
    for (const CheckOutcome &check : report.checks)
        checks.append(jsonOf(check));
    const QJsonObject json{{QStringLiteral("format"), 1},
                           {QStringLiteral("lab"), report.labId},
                           {QStringLiteral("lab_hash"), report.labHash},
                           {QStringLiteral("task"), report.taskId},
                           {QStringLiteral("seed"), report.seed},
                           {QStringLiteral("passed"), report.passed},
                           {QStringLiteral("commit"), report.commit},
                           {QStringLiteral("checks"), checks},
                           {QStringLiteral("diagnosis"), jsonOf(report.diagnosis)},
                           {QStringLiteral("remarks"), jsonOf(report.remarks)},
                           {QStringLiteral("error"), jsonOf(report.error)},
                           {QStringLiteral("elapsed_ms"), report.elapsedMs}};
    return QJsonDocument(json).toJson();
}

QString describeReport(const CheckReport &report)
{
    QString text;
    if (report.error)
        text += ReportText::tr("  line %1: %2\n").arg(report.error->line).arg(report.error->message);
    if (report.diagnosis)
        text += indented(report.diagnosis->message);
    for (const CheckOutcome &check : report.checks) {
        text += (check.passed ? QStringLiteral("  ok    ") : QStringLiteral("  FAIL  "))
                + check.title + QLatin1Char('\n');
        if (!check.passed) {
            text += QStringLiteral("        ") + check.message + QLatin1Char('\n');
            if (!check.variant.isEmpty() && check.variant != QLatin1String("preset"))
                text += QStringLiteral("        ")
                        + ReportText::tr("in the scene: %1").arg(check.variant) + QLatin1Char('\n');
        }
    }
    for (const Remark &remark : report.remarks)
        text += indented(remark.message);
    text += report.passed ? ReportText::tr("%1 passed").arg(report.taskId)
                          : ReportText::tr("%1 did not pass").arg(report.taskId);
    return text + QLatin1Char('\n');
}

} // namespace cradle
