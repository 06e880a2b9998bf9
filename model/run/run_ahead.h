// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/runner.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace cradle {

/// Looks for the next contact of a run on a thread of its own: makes steps until one begins a
/// contact, the program stops or a time is reached. The steps wait here to be taken, some thousand
/// at most.
class RunAhead
{
public:
    /// A step that was made.
    struct Step {
        World world{}; ///< at its end
        std::vector<Hit> hits{};
        ProgramOutput output{};
        std::optional<double> mergedFrom{}; ///< Runner::mergedFrom()
    };

    RunAhead() = default;
    ~RunAhead() { stop(); }
    RunAhead(const RunAhead &) = delete;
    RunAhead &operator=(const RunAhead &) = delete;

    /// Begins. Until stop(), or isDone(), \p run and \p program belong to that thread.
    /// \param program   whose output is taken where it moves the circles; null for none
    /// \param contacts  those of the run so far: who goes on with one of them begins none
    /// \param end       time that is not passed by more than a step, s
    void start(Runner &run, Program *program, const EncounterLog &contacts, double end);

    /// Ends it, as soon as the step is done that is made now, or a part of it (Runner::advance());
    /// until then it waits. Steps that were not taken can be taken still.
    void stop();

    /// Whether no more steps come.
    [[nodiscard]] bool isDone() const { return m_done; }

    /// The oldest step that was not taken; none if there is none now.
    [[nodiscard]] std::optional<Step> take();

private:
    void work(const std::stop_token &stopped, Runner &run, Program *program, EncounterLog contacts,
              double end);
    void hand(Step step, const std::stop_token &stopped);

    std::jthread m_thread; ///< what it is replaced by waits for its end
    std::atomic_bool m_done = true;
    std::mutex m_lock; ///< of the steps
    std::condition_variable_any m_taken;
    std::deque<Step> m_steps;
    std::size_t m_mostSteps = 1;
};

} // namespace cradle
