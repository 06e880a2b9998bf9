// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/student_result_json.h"

#include "tasks/grading/points.h"
#include "tasks/report/report_json.h"
#include "tasks/values/lab_values.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace cradle {

namespace {

/// Adds to the report what only pages need.
QJsonObject jsonOf(const CheckReport &report)
{
    QJsonObject json = reportObject(report);
    if (report.error) {
        QJsonObject error = json.value(QStringLiteral("error")).toObject();
        error.insert(QStringLiteral("time"), report.error->time);
        QJsonArray locals;
        for (const ProgramValue &local : report.error->locals)
            locals.append(QJsonArray{local.name, local.value});
        error.insert(QStringLiteral("locals"), locals);
        json.insert(QStringLiteral("error"), error);
    }
    return json;
}

QJsonArray jsonOf(Vec2 v)
{
    return {v.x, v.y};
}

QJsonObject jsonOf(const StepMoment &moment)
{
    QJsonArray bodies;
    for (const DrawnMoment::Body &body : moment.scene.bodies) {
        QJsonArray way; // x and y in turn
        for (const Vec2 &point : body.way) {
            way.append(point.x);
            way.append(point.y);
        }
        bodies.append(QJsonObject{{QStringLiteral("colour"), body.colour},
                                  {QStringLiteral("radius"), body.radius},
                                  {QStringLiteral("position"), jsonOf(body.position)},
                                  {QStringLiteral("velocity"), jsonOf(body.velocity)},
                                  {QStringLiteral("way"), way}});
    }
    return {{QStringLiteral("check"), moment.check},
            {QStringLiteral("half_width"), moment.scene.halfWidth},
            {QStringLiteral("time"), moment.scene.time},
            {QStringLiteral("circles"), bodies}};
}

QJsonValue jsonOf(const std::optional<double> &points)
{
    return points ? QJsonValue(roundedPoints(*points)) : QJsonValue(QJsonValue::Null);
}

QJsonObject jsonOf(const StepResult &step, const Lab &lab)
{
    QJsonArray moments;
    for (const StepMoment &moment : step.moments)
        moments.append(jsonOf(moment));
    QJsonObject json{{QStringLiteral("task"), step.taskId},
                     {QStringLiteral("status"), statusName(step.status)},
                     {QStringLiteral("reason"), step.reason},
                     {QStringLiteral("report"), step.report ? QJsonValue(jsonOf(*step.report))
                                                            : QJsonValue(QJsonValue::Null)},
                     {QStringLiteral("moments"), moments},
                     {QStringLiteral("program"), step.program},
                     {QStringLiteral("attempts"), step.attempts},
                     {QStringLiteral("minutes"), step.minutes}};
    if (!step.drawnBy.isEmpty() || !step.ownNumber.isEmpty()) {
        json.insert(QStringLiteral("values_of"), step.drawnBy);
        json.insert(QStringLiteral("number_handed_in"), step.ownNumber);
        json.insert(QStringLiteral("number_differs"), step.hasForeignNumber());
    }
    if (const int index = lab.indexOf(step.taskId); index >= 0) {
        const Task &task = lab.tasks[static_cast<std::size_t>(index)];
        const Points points = pointsOf(step, task);
        json.insert(QStringLiteral("title"), task.title);
        json.insert(QStringLiteral("points"), jsonOf(points.earned));
        json.insert(QStringLiteral("max_points"), points.most);
    }
    return json;
}

} // namespace

bool StepResult::hasForeignNumber() const
{
    return !ownNumber.isEmpty() && plainNumber(ownNumber) != plainNumber(drawnBy);
}

QByteArray writeStudentResult(const StudentResult &result, const Lab &lab)
{
    QJsonArray steps;
    for (const StepResult &step : result.steps)
        steps.append(jsonOf(step, lab));
    const QJsonObject json{
        {QStringLiteral("format"), 1},
        {QStringLiteral("student"),
         QJsonObject{{QStringLiteral("id"), result.id},
                     {QStringLiteral("name"), result.name},
                     {QStringLiteral("number"), result.number},
                     {QStringLiteral("email"), result.email},
                     {QStringLiteral("platform"), platformText(result.platform)}}},
        {QStringLiteral("lab"), QJsonObject{{QStringLiteral("id"), lab.id},
                                            {QStringLiteral("version"), lab.version},
                                            {QStringLiteral("hash"), lab.hash}}},
        {QStringLiteral("seed"), result.seed},
        {QStringLiteral("late_days"), result.lateDays},
        {QStringLiteral("remark"), result.remark},
        {QStringLiteral("steps"), steps}};
    return QJsonDocument(json).toJson(QJsonDocument::Compact) + '\n';
}

} // namespace cradle
