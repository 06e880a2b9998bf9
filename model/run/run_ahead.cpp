// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/run_ahead.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

/// Of steps that wait: enough for a frame of the fastest run.
constexpr std::size_t mostSteps = 8192;
constexpr std::size_t mostBytes = 16 * 1024 * 1024;

} // namespace

void RunAhead::start(Runner &run, Program *program, const EncounterLog &contacts, double end)
{
    stop();
    m_steps.clear();
    const std::size_t bytes = std::max<std::size_t>(1, run.world().circles.size()) * sizeof(Circle);
    m_mostSteps = std::clamp<std::size_t>(mostBytes / bytes, 1, mostSteps);
    m_done = false;
    m_thread =
        std::jthread([this, &run, program, contacts, end](const std::stop_token &stopped) mutable {
            work(stopped, run, program, std::move(contacts), end);
            m_done = true;
        });
}

void RunAhead::stop()
{
    m_thread = {};
}

void RunAhead::work(const std::stop_token &stopped, Runner &run, Program *program,
                    EncounterLog contacts, double end)
{
    while (!stopped.stop_requested() && run.world().time < end) {
        const Runner::Progress progress = run.advance(run.scene().timestep, Runner::eventsAtOnce);
        if (progress == Runner::Progress::Failed)
            return;
        if (progress == Runner::Progress::Begun)
            continue;
        const World &world = run.world();
        contacts.add(run.hits(), world.circles, 0);
        hand({world, run.hits(), run.isProgrammed() ? program->takeOutput() : ProgramOutput{},
              run.mergedFrom()},
             stopped);
        if (!contacts.encounters().empty() && contacts.encounters().back().step == world.step)
            return;
    }
}

/// Waits while too many were not taken.
void RunAhead::hand(Step step, const std::stop_token &stopped)
{
    std::unique_lock lock(m_lock);
    m_taken.wait(lock, stopped, [this] { return m_steps.size() < m_mostSteps; });
    m_steps.push_back(std::move(step));
}

std::optional<RunAhead::Step> RunAhead::take()
{
    std::optional<Step> step;
    {
        const std::scoped_lock lock(m_lock);
        if (m_steps.empty())
            return step;
        step = std::move(m_steps.front());
        m_steps.pop_front();
    }
    m_taken.notify_one();
    return step;
}

} // namespace cradle
