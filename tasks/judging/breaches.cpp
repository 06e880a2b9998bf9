// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/breaches.h"

#include "tasks/script/locks.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct BreachText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

} // namespace

std::optional<CheckOutcome> moverBreach(const Task &task, bool byProgram)
{
    const bool idle = task.moves == Mover::Program && !byProgram;
    const bool busy = task.moves == Mover::Laws && byProgram;
    if (!idle && !busy)
        return std::nullopt;
    return CheckOutcome{
        .id = QStringLiteral("moves"),
        .title = idle ? BreachText::tr("Your program moves the circles")
                      : BreachText::tr("The laws of the scene move the circles"),
        .message =
            idle ? BreachText::tr("Nothing in your program moves the circles: write on_update")
                 : BreachText::tr("Your program moves the circles: leave on_update out, and "
                                  "the laws of the scene do it")};
}

std::optional<CheckOutcome> lockBreach(const Task &task, const Preset &submitted)
{
    const auto field = firstChangedLock(task.preset, submitted, task.locked);
    if (!field)
        return std::nullopt;
    return CheckOutcome{.id = QStringLiteral("locked"),
                        .title = BreachText::tr("What the step fixes is as the step has it"),
                        .message = lockReason(*field, task.preset)};
}

} // namespace cradle
