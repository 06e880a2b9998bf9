// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_results.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/reading/lab_reader.h"

#include "model/files/file_io.h"

#include <QDir>

/// A small class without running anything: one who passes, one who does not and means harm, one
/// whose work could not be graded.
namespace cradle::classes {

inline const QString hostileName =
    QStringLiteral("=HYPERLINK(\"x\") <script>alert(1)</script>,\"Mallory\"\n\u202e");

/// A lab of two steps, worth 3 and 2.5 points.
inline Lab smallLab()
{
    Lab lab{.id = QStringLiteral("small"),
            .title = QStringLiteral("A small <lab>"),
            .version = QStringLiteral("7"),
            .language = QStringLiteral("en"),
            .folder = {},
            .hash = QStringLiteral("0123abcd")};
    for (const char *id : {"S1", "S2"}) {
        Task task;
        task.id = QString::fromLatin1(id);
        task.title = QStringLiteral("Step %1").arg(task.id);
        task.checks = {CheckSpec{.id = QStringLiteral("start"),
                                 .title = QStringLiteral("It starts & goes"),
                                 .kind = QStringLiteral("start")},
                       CheckSpec{.id = QStringLiteral("moves"),
                                 .title = QStringLiteral("It moves"),
                                 .kind = QStringLiteral("integrates")}};
        task.checks[1].points = lab.tasks.empty() ? 2.0 : 1.5;
        lab.tasks.push_back(task);
    }
    return lab;
}

inline StepResult judged(const Lab &lab, std::size_t index, bool starts, bool moves)
{
    const Task &task = lab.tasks[index];
    CheckReport report{.labId = lab.id, .labHash = lab.hash, .taskId = task.id};
    report.passed = starts && moves;
    report.byProgram = true;
    for (const CheckSpec &check : task.checks) {
        const bool passed = check.id == QLatin1String("start") ? starts : moves;
        report.checks.push_back({.id = check.id,
                                 .title = check.title,
                                 .passed = passed,
                                 .message = passed ? QString() : QStringLiteral("1 < 2 & so on"),
                                 .points = check.points});
    }
    if (!report.passed)
        report.findings = {Finding{.aspect = Aspect::Motion,
                                   .mistake = QStringLiteral("backwards"),
                                   .message = QStringLiteral("It goes *backwards*\n\nLook at "
                                                             "`v * t` & <b>the sign</b>."),
                                   .check = QStringLiteral("moves"),
                                   .line = 2}};
    StepResult step{.taskId = task.id,
                    .status =
                        report.passed ? StepResult::Status::Passed : StepResult::Status::Failed,
                    .report = report};
    if (!report.passed)
        step.moments = {{QStringLiteral("moves"),
                         {.time = 0.5,
                          .bodies = {{.colour = QStringLiteral("#1e90ff"),
                                      .position = {1.0, 1.0},
                                      .velocity = {2.0, 0.0},
                                      .way = {{0.0, 1.0}, {0.5, 1.0}}}}}}};
    return step;
}

inline StudentResult ada(const Lab &lab)
{
    return {.id = QStringLiteral("ada"),
            .name = QStringLiteral("Ada Lovelace"),
            .number = QStringLiteral("0042"),
            .email = QStringLiteral("ada@example.org"),
            .lateDays = 1.5,
            .steps = {judged(lab, 0, true, true), judged(lab, 1, true, true)}};
}

inline StudentResult mallory(const Lab &lab)
{
    StudentResult student{.id = QStringLiteral("mallory"),
                          .name = hostileName,
                          .number = QStringLiteral("-77"),
                          .platform = Platform::Canvas,
                          .remark = QStringLiteral("</div><img src=x onerror=alert(2)>"),
                          .steps = {judged(lab, 0, true, false), {.taskId = lab.tasks[1].id}}};
    student.steps[0].program = QStringLiteral("-- by Mallory </pre><script>alert(3)</script>\n"
                                              "local mallory = \"<!--\" ]]> & Mallory %1 %2\n"
                                              "--[[ Mallory again ]]\n");
    student.steps[0].attempts = 4;
    student.steps[0].minutes = 12.0;
    return student;
}

inline StudentResult bob(const Lab &lab)
{
    return {.id = QStringLiteral("bob"),
            .name = QStringLiteral("Bob Dobbs"),
            .number = QStringLiteral("99"),
            .platform = Platform::Moodle,
            .steps = {judged(lab, 0, true, true),
                      {.taskId = lab.tasks[1].id,
                       .status = StepResult::Status::NotGraded,
                       .reason = QStringLiteral("the machine & all failed")}}};
}

inline ClassFacts facts()
{
    return {.className = QStringLiteral("Class <1>"),
            .isolation = QStringLiteral("rlimits"),
            .program = QStringLiteral("Cradle 1"),
            .late = {.percentPerDay = 10.0},
            .missing = {{.id = QStringLiteral("eve"), .name = QStringLiteral("Eve, Nobody")}},
            .remarks = {QStringLiteral("a remark & more")}};
}

/// Keeps them in \p folder as a grader does. \return whether that went well
inline bool keep(const QString &folder, const std::vector<StudentResult> &students, const Lab &lab)
{
    if (!QDir().mkpath(folder + QStringLiteral("/students")))
        return false;
    for (const StudentResult &student : students) {
        if (writeFile(QStringLiteral("%1/students/%2.json").arg(folder, student.id),
                      writeStudentResult(student, lab)))
            return false;
    }
    return true;
}

} // namespace cradle::classes
