// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/runner.h"
#include "tasks/script/student_script.h"
#include "tasks/script/work_limit.h"

#include <functional>

namespace cradle {

/// A scene that is staged to see one thing.
struct Stage {
    Preset preset{};
    bool pinned = true; ///< a program cannot change what it starts with
};

/// A submission at work in one stage: its program, or the laws of the scene where none moves the
/// circles. It goes on step by step.
class Probe
{
public:
    /// \param program  null where the laws of the scene are asked
    /// \param once     nobody is likely to look at that program again; it stops where it takes far
    ///                 more work than any that is right
    Probe(const QString *program, const Stage &stage, bool once = false);

    /// Whether it runs at all, and has not stopped with an error.
    [[nodiscard]] bool runs() const { return !m_run.error(); }
    /// The scene as the program left it before the first step.
    [[nodiscard]] const Preset &start() const { return m_run.scene(); }
    /// The state now.
    [[nodiscard]] const World &world() const { return m_run.world(); }
    [[nodiscard]] const Circle &circle(int i) const
    {
        return world().circles[static_cast<std::size_t>(i)];
    }
    /// Goes on from \p world, which has as many circles.
    void place(const World &world) { m_run.place(world); }
    /// Makes one step. \return false if the program stopped with an error, or the WorkLimit is
    /// passed
    bool step() { return !WorkLimit::isPassed() && m_run.step(); }
    /// The same with another timestep, s.
    bool step(double dt)
    {
        return !WorkLimit::isPassed() && m_run.advance(dt) == Runner::Progress::Done;
    }
    /// What its program has worked so far, in instructions; 0 for laws.
    [[nodiscard]] qint64 instructions() const;
    /// What the next step assigns to the circles, in order; the step is made.
    [[nodiscard]] std::vector<Assignment> trace();
    /// The lines that run in the next step; the step is made.
    [[nodiscard]] std::vector<int> lines();

private:
    [[nodiscard]] bool isProgrammed() const { return m_run.isProgrammed(); }

    std::optional<StudentScript> m_program{};
    Runner m_run;
};

/// The circles after so many steps of a program that is looked at once; nothing if it stops.
[[nodiscard]] std::optional<World> worldAfter(const QString &program, const Stage &stage,
                                              qint64 steps);

} // namespace cradle
