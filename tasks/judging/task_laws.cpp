// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/task_laws.h"

#include "tasks/judging/asked_laws.h"

#include <algorithm>

namespace cradle {

namespace {

/// Steps of which a thread keeps the laws: those of a lab.
constexpr std::size_t mostKept = 20;

std::vector<std::shared_ptr<const TaskLaws>> &keptLaws()
{
    thread_local std::vector<std::shared_ptr<const TaskLaws>> kept;
    return kept;
}

bool isSame(const std::vector<KnownScript> &a, const std::vector<KnownScript> &b)
{
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const KnownScript &p, const KnownScript &q) { return p.source == q.source; });
}

std::optional<Ground> askedGround(const Task &task)
{
    if (!task.forStudents)
        return std::nullopt;
    return Ground(task, askedLaws(task).scene);
}

/// Whether an update takes no more than that of a sound program.
bool isQuick(const QString &program, const Ground &ground)
{
    constexpr int steps = 3;
    constexpr qint64 mostWork = 4'000; // instructions of a step
    Probe probe(&program, {ground.own, false});
    for (int k = 0; k < steps && probe.step(); ++k) {
    }
    return probe.runs() && probe.instructions() < (steps + 1) * mostWork;
}

} // namespace

TaskLaws::TaskLaws(const Task &task)
    : m_task(task)
    , m_ground(m_task, m_task.preset)
    , m_asked(askedGround(m_task))
    , m_right(m_asked ? nullptr : &m_task.solution, m_asked ? *m_asked : m_ground)
{
    for (const KnownScript &mistake : m_task.mistakes)
        m_mistakes.push_back(std::make_unique<const MeasuredLaws>(&mistake.source, m_ground));
}

bool TaskLaws::areOf(const Task &task) const
{
    return m_task.id == task.id && m_task.solution == task.solution && m_task.preset == task.preset
           && m_task.forStudents == task.forStudents && m_task.solutionScene == task.solutionScene
           && m_task.locked == task.locked && isSame(m_task.mistakes, task.mistakes)
           && m_task.checks == task.checks;
}

void TaskLaws::measureAll() const
{
    const auto measure = [&](const MeasuredLaws &laws, const QString &program) {
        if (!isQuick(program, m_ground))
            return;
        for (const Vec2 gravity : m_ground.gravities) {
            for (const double h : m_ground.timesteps)
                (void)laws.flight().at(gravity, h);
        }
        if (!m_ground.walls.circles.empty())
            (void)laws.walls();
        if (m_ground.pair.asked)
            (void)laws.pair();
    };
    if (m_ground.timesteps.empty() || m_ground.gravities.empty())
        return; // Nothing is measured then.
    measure(m_right, m_task.solution);
    for (std::size_t i = 0; i < m_mistakes.size(); ++i)
        measure(*m_mistakes[i], m_task.mistakes[i].source);
}

std::shared_ptr<const TaskLaws> lawsOf(const Task &task)
{
    std::vector<std::shared_ptr<const TaskLaws>> &kept = keptLaws();
    const auto found =
        std::find_if(kept.begin(), kept.end(), [&](const auto &laws) { return laws->areOf(task); });
    if (found != kept.end()) {
        std::rotate(found, found + 1, kept.end()); // the last asked for is the last to go
        return kept.back();
    }
    if (kept.size() >= mostKept)
        kept.erase(kept.begin());
    kept.push_back(std::make_shared<const TaskLaws>(task));
    return kept.back();
}

void forgetLaws()
{
    keptLaws().clear();
}

} // namespace cradle
