// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/points.h"

#include "tasks/report/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cradle {

namespace {

constexpr std::array statusNames{
    std::pair{StepResult::Status::Passed, "passed"},
    std::pair{StepResult::Status::Failed, "failed"},
    std::pair{StepResult::Status::Missing, "missing"},
    std::pair{StepResult::Status::NotGraded, "not_graded"},
};

/// Of every check, and of every question that is not the teacher's.
std::vector<std::pair<QString, double>> partsOf(const Task &task)
{
    std::vector<std::pair<QString, double>> parts;
    for (const CheckSpec &check : task.checks)
        parts.emplace_back(check.id, check.points);
    for (const Question &question : task.questions) {
        if (question.kind != Question::Kind::Text)
            parts.emplace_back(question.id, question.points);
    }
    return parts;
}

double pointsOfAll(const Task &task)
{
    double sum = 0.0;
    for (const auto &[id, points] : partsOf(task))
        sum += points;
    return sum;
}

} // namespace

double mostPoints(const Task &task)
{
    return task.points.value_or(pointsOfAll(task));
}

double pointScale(const Task &task)
{
    const double all = pointsOfAll(task);
    return task.points && all > 0.0 ? *task.points / all : 1.0;
}

double pointsInside(const Task &task, const QString &id)
{
    for (const auto &[each, points] : partsOf(task)) {
        if (each == id)
            return points;
    }
    return 0.0;
}

Points pointsOf(const StepResult &step, const Task &task)
{
    const double most = mostPoints(task);
    switch (step.status) {
    case StepResult::Status::NotGraded:
        return {std::nullopt, most};
    case StepResult::Status::Passed:
        return {most, most};
    case StepResult::Status::Missing:
        return {0.0, most};
    case StepResult::Status::Failed:
        break;
    }
    // A check that is not in the lab brings nothing, whatever a report says.
    const auto passed = [&](const QString &id) {
        return step.report
               && std::any_of(
                   step.report->checks.begin(), step.report->checks.end(),
                   [&](const CheckOutcome &each) { return each.id == id && each.passed; });
    };
    double sum = 0.0;
    for (const auto &[id, points] : partsOf(task))
        sum += passed(id) ? points : 0.0;
    return {sum * pointScale(task), most};
}

Points pointsOf(const StudentResult &student, const Lab &lab, const LateRule &rule)
{
    Points all{0.0, 0.0};
    for (const Task &task : lab.tasks) {
        const Points points = pointsOf(resultOf(student, task), task);
        all.most += points.most;
        if (!points.earned)
            all.earned.reset();
        else if (all.earned)
            *all.earned += *points.earned;
    }
    if (all.earned)
        all.earned = roundedPoints(*all.earned * keptWhenLate(student.lateDays, rule));
    return all;
}

double keptWhenLate(double lateDays, const LateRule &rule)
{
    const double days = std::ceil(std::max(0.0, lateDays));
    const double percent = std::min(days * rule.percentPerDay, rule.mostPercent);
    return 1.0 - std::clamp(percent, 0.0, 100.0) / 100.0;
}

double roundedPoints(double points)
{
    // What should be a half is often a little less in binary.
    return std::floor(points * 100.0 + 0.5 + 1e-9) / 100.0;
}

QString pointsText(double points)
{
    QString text = QString::number(roundedPoints(points), 'f', 2);
    while (text.endsWith(QLatin1Char('0')))
        text.chop(1);
    if (text.endsWith(QLatin1Char('.')))
        text.chop(1);
    return text;
}

QString statusName(StepResult::Status status)
{
    const auto *found = std::find_if(statusNames.begin(), statusNames.end(),
                                     [&](const auto &each) { return each.first == status; });
    return QString::fromLatin1(found->second);
}

std::optional<StepResult::Status> statusFromName(const QString &name)
{
    for (const auto &[status, each] : statusNames) {
        if (name == QLatin1String(each))
            return status;
    }
    return std::nullopt;
}

const StepResult &resultOf(const StudentResult &student, const Task &task)
{
    static const StepResult missing{};
    const auto found = std::find_if(student.steps.begin(), student.steps.end(),
                                    [&](const StepResult &step) { return step.taskId == task.id; });
    return found == student.steps.end() ? missing : *found;
}

} // namespace cradle
