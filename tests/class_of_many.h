// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/class_of_three.h"

namespace cradle::classes {

/// Student \p i of a class of any size: all combinations of verdicts, points, lateness, histories
/// and numbers; every fifth took over most of another's program.
inline StudentResult oneOfMany(const Lab &lab, int i)
{
    StudentResult student{
        .id = QStringLiteral("s%1").arg(i, 4, 10, QLatin1Char('0')),
        .name = i % 13 == 0 ? QString() : QStringLiteral("Student %1 Number").arg(i),
        .number = i % 3 == 0 ? QString() : QString::number(100'000 + 37 * i),
        .email = i % 2 == 0 ? QStringLiteral("s%1@example.org").arg(i) : QString(),
        .platform = static_cast<Platform>(i % 4),
        .lateDays = i % 6 == 0 ? 0.25 * (i % 40) : 0.0,
        .remark = i % 17 == 0 ? QStringLiteral("remark %1").arg(i) : QString()};
    for (std::size_t s = 0; s < lab.tasks.size(); ++s) {
        const int kind = (i + 3 * static_cast<int>(s)) % 11;
        StepResult step{.taskId = lab.tasks[s].id};
        if (kind == 0) {
            step.status = StepResult::Status::NotGraded;
            step.reason = QStringLiteral("reason %1").arg(i % 5);
        } else if (kind != 1) {
            step = judged(lab, s, kind != 2 && kind != 5, kind > 4);
        }
        if (step.report) {
            for (Finding &finding : step.report->findings) {
                finding.aspect = static_cast<Aspect>(i % 6);
                finding.line = i % 9 - 1;
                if (i % 2 == 0) // a law, in words of its own
                    finding.mistake.clear();
                finding.message =
                    QStringLiteral("Headline %1\n\nOf `s%2` *more*.").arg(i % 23).arg(i % 4);
            }
            if (kind == 2)
                step.report->error = ProgramError{.message = QStringLiteral("stopped"), .line = 3};
            for (int line = 0; line < 12 + i % 40; ++line)
                step.program += QStringLiteral("local v%1_%2 = %3 * circle%4.velocity.x\n")
                                    .arg(i % 5 == 0 && line % 9 != 0 ? 5 : i)
                                    .arg(line)
                                    .arg(line * (static_cast<int>(s) + 2))
                                    .arg(line % 2 + 1);
        }
        step.attempts = i % 4 == 0 ? i % 9 : 0;
        step.minutes = i % 5 == 0 ? 1.5 * (i % 60) : 0.0;
        if (i % 10 < 3) {
            step.drawnBy = student.number;
            step.ownNumber = i % 20 == 1 ? QStringLiteral("100037") : student.number;
        }
        student.steps.push_back(std::move(step));
    }
    return student;
}

} // namespace cradle::classes
