// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_laws.h"

#include <memory>
#include <optional>

namespace cradle {

/// The laws of a step's own programs in its own scene. They depend on the step alone, not on who is
/// judged or from which seed, so they are measured once for all.
class TaskLaws
{
public:
    explicit TaskLaws(const Task &task);
    TaskLaws(const TaskLaws &) = delete;
    TaskLaws &operator=(const TaskLaws &) = delete;

    /// Whether they are those of \p task.
    [[nodiscard]] bool areOf(const Task &task) const;

    [[nodiscard]] const Ground &ground() const { return m_ground; }
    [[nodiscard]] const MeasuredLaws &right() const { return m_right; }
    /// \param i  of the mistakes of the step, from 0
    [[nodiscard]] const MeasuredLaws &mistake(std::size_t i) const { return *m_mistakes[i]; }
    /// Measures now what else is measured when it is asked for, but of no program that takes long.
    void measureAll() const;

private:
    Task m_task;
    Ground m_ground;
    std::optional<Ground> m_asked{}; ///< with the laws of the checks, where there is no solution
    MeasuredLaws m_right;
    std::vector<std::unique_ptr<const MeasuredLaws>> m_mistakes{};
};

/// Those of \p task. Each thread keeps them for the steps that it judged last; a process that was
/// forked has those that the thread had.
[[nodiscard]] std::shared_ptr<const TaskLaws> lawsOf(const Task &task);

/// Forgets those that this thread keeps: for measurements.
void forgetLaws();

} // namespace cradle
