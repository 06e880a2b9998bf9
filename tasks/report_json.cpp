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
            {QStringLiteral("variant"), check.variant}};
}

} // namespace

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
                           {QStringLiteral("diagnosis"), QJsonValue(QJsonValue::Null)},
                           {QStringLiteral("remarks"), QJsonArray()},
                           {QStringLiteral("error"), QJsonValue(QJsonValue::Null)},
                           {QStringLiteral("elapsed_ms"), report.elapsedMs}};
    return QJsonDocument(json).toJson();
}

QString describeReport(const CheckReport &report)
{
    QString text;
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
    text += report.passed ? ReportText::tr("%1 passed").arg(report.taskId)
                          : ReportText::tr("%1 did not pass").arg(report.taskId);
    return text + QLatin1Char('\n');
}

} // namespace cradle
