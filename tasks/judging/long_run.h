// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/ground.h"
#include "tasks/judging/probe.h"

namespace cradle {

/// A run of a program in which the circles are set anew now and then, while the program goes on: so
/// the same is seen early and late, for the first time and again, here and there.
class LongRun
{
public:
    /// \param scene  with the gravity, the e and the timestep of what is to be seen
    LongRun(const QString *program, const Ground &ground, const Preset &scene);

    /// Whether the program goes on from where its circles are set, and has not stopped.
    [[nodiscard]] bool runs() const { return m_isFollowed && m_probe.runs(); }
    [[nodiscard]] Probe &probe() { return m_probe; }
    [[nodiscard]] double time() const { return m_probe.world().time; }

    /// Sets the circles where those of \p scene begin, with their velocities. What they are they
    /// stay: a program may keep radii and masses from the start on.
    void set(const Preset &scene);
    /// Lets circles fly far from walls and each other for so long, in long steps.
    void wait(double seconds);

private:
    void place(const Preset &scene);

    Preset m_idle; ///< how they fly meanwhile
    double m_step; ///< then, s
    Probe m_probe;
    bool m_isFollowed = true;
    bool m_wasSet = false; ///< by others than the waits
};

} // namespace cradle
