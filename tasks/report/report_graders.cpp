// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_formats.h"

#include "tasks/report/report_text.h"
#include "tasks/text/plain_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace cradle {

namespace {

/// Exercism takes no longer texts.
constexpr qsizetype longestMessage = 60'000;
constexpr qsizetype longestOutput = 500;

/// The name of a file alone: where it lay in the grader says nothing to the student.
QString fileName(const QString &program)
{
    return program.section(QLatin1Char('/'), -1);
}

/// CommonMark: what explains the verdict, the verdict, the remarks.
QString overview(const CheckReport &report, const QString &program)
{
    QStringList parts;
    if (report.error)
        parts.append(QStringLiteral("```\n%1\n```").arg(explanationOf(report, program)));
    for (const Finding &finding : report.findings)
        parts.append(withPlainFormulas(finding.message));
    parts.append(verdictOf(report));
    for (const Remark &remark : report.remarks)
        parts.append(withPlainFormulas(remark.message));
    return parts.join(QStringLiteral("\n\n"));
}

QString remarksOf(const CheckReport &report)
{
    QStringList parts;
    for (const Remark &remark : report.remarks)
        parts.append(plainText(remark.message, terminalColumns));
    return parts.join(QStringLiteral("\n\n"));
}

QString statusOf(const CheckReport &report, const CheckOutcome &check)
{
    if (check.passed)
        return QStringLiteral("pass");
    return wasStopped(report, check) ? QStringLiteral("error") : QStringLiteral("fail");
}

bool nothingJudged(const CheckReport &report)
{
    return report.error
           && std::all_of(report.checks.begin(), report.checks.end(),
                          [&](const CheckOutcome &check) { return wasStopped(report, check); });
}

QString overallStatus(const CheckReport &report)
{
    if (report.passed)
        return QStringLiteral("pass");
    return nothingJudged(report) ? QStringLiteral("error") : QStringLiteral("fail");
}

} // namespace

QString testCodeOf(const Task *task, const QString &checkId)
{
    if (!task)
        return {};
    const auto check = std::find_if(task->checks.begin(), task->checks.end(),
                                    [&](const CheckSpec &each) { return each.id == checkId; });
    if (check == task->checks.end())
        return {};
    if (!check->source.isEmpty())
        return check->source;
    QJsonObject json{{QStringLiteral("kind"), check->kind}};
    if (!check->parameters.isEmpty())
        json.insert(QStringLiteral("parameters"), check->parameters);
    if (!check->scene.isEmpty())
        json.insert(QStringLiteral("scene"), check->scene);
    return QString::fromUtf8(QJsonDocument(json).toJson()).trimmed();
}

QByteArray writeGradescope(const CheckReport &report, const QString &program)
{
    const QString file = fileName(program);
    QJsonArray tests;
    for (const CheckOutcome &check : report.checks)
        tests.append(
            QJsonObject{{QStringLiteral("name"), check.title},
                        {QStringLiteral("score"), check.passed ? check.points : 0.0},
                        {QStringLiteral("max_score"), check.points},
                        {QStringLiteral("status"),
                         check.passed ? QStringLiteral("passed") : QStringLiteral("failed")},
                        {QStringLiteral("output"),
                         check.passed && !check.forTeacher
                             ? QString()
                             : observationsOf(report, check, file).join(QLatin1Char('\n'))},
                        {QStringLiteral("output_format"), QStringLiteral("text")}});
    QJsonObject extra{{QStringLiteral("lab"), report.labId},
                      {QStringLiteral("lab_hash"), report.labHash},
                      {QStringLiteral("task"), report.taskId},
                      {QStringLiteral("seed"), report.seed}};
    const QStringList mistakes = mistakesOf(report);
    if (!mistakes.isEmpty())
        extra.insert(QStringLiteral("mistake"), mistakes.join(QStringLiteral(", ")));
    const QJsonObject json{
        {QStringLiteral("score"), scoreOf(report)},
        {QStringLiteral("execution_time"), static_cast<double>(report.elapsedMs) / 1000.0},
        {QStringLiteral("output"), overview(report, file)},
        {QStringLiteral("output_format"), QStringLiteral("md")},
        {QStringLiteral("tests"), tests},
        {QStringLiteral("extra_data"), extra}};
    return QJsonDocument(json).toJson();
}

QByteArray writeExercism(const CheckReport &report, const QString &program, const Task *task)
{
    const QString file = fileName(program);
    QJsonArray tests;
    for (std::size_t i = 0; i < report.checks.size(); ++i) {
        const CheckOutcome &check = report.checks[i];
        QJsonObject test{{QStringLiteral("name"), check.title},
                         {QStringLiteral("status"), statusOf(report, check)}};
        if (const QString code = testCodeOf(task, check.id); !code.isEmpty())
            test.insert(QStringLiteral("test_code"), code);
        if (!check.passed)
            test.insert(QStringLiteral("message"),
                        feedbackOn(report, i, file).left(longestMessage));
        // A message belongs to a failure; what is said of work that passes has one place, the
        // output.
        if (i == 0 && !report.remarks.empty())
            test.insert(QStringLiteral("output"), remarksOf(report).left(longestOutput));
        tests.append(test);
    }
    QJsonObject json{{QStringLiteral("version"), 3}, {QStringLiteral("tests"), tests}};
    json.insert(QStringLiteral("status"), overallStatus(report));
    json.insert(QStringLiteral("message"),
                nothingJudged(report) ? QJsonValue(explanationOf(report, file).left(longestMessage))
                                      : QJsonValue(QJsonValue::Null));
    return QJsonDocument(json).toJson();
}

QByteArray writeGitHub(const CheckReport &report, const QString &program, const Task *task)
{
    const QString file = fileName(program);
    QJsonArray tests;
    for (std::size_t i = 0; i < report.checks.size(); ++i) {
        const CheckOutcome &check = report.checks[i];
        // What is said of work that passes has no other place.
        const QString message = i == 0 && check.passed && !check.forTeacher
                                    ? remarksOf(report)
                                    : feedbackOn(report, i, file);
        tests.append(QJsonObject{{QStringLiteral("name"), check.title},
                                 {QStringLiteral("status"), statusOf(report, check)},
                                 {QStringLiteral("score"), check.passed ? check.points : 0.0},
                                 {QStringLiteral("message"), message},
                                 {QStringLiteral("test_code"), testCodeOf(task, check.id)},
                                 {QStringLiteral("filename"), file},
                                 {QStringLiteral("line_no"), check.line}});
    }
    return QJsonDocument(QJsonObject{{QStringLiteral("version"), 1},
                                     {QStringLiteral("status"), overallStatus(report)},
                                     {QStringLiteral("max_score"), fullScoreOf(report)},
                                     {QStringLiteral("tests"), tests}})
        .toJson();
}

} // namespace cradle
