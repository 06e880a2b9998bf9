// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/recording.h"
#include "tasks/variant.h"

namespace cradle {

/// What a submission did in one scene. The checks see only this: positions and velocities over
/// time, and the scene that was pinned; never how they came about.
struct Observation {
    Variant variant;
    Recording states;

    [[nodiscard]] qint64 steps() const { return states.last(); }
    [[nodiscard]] const Circle &circle(int index, qint64 step) const
    {
        return states.circles(step)[static_cast<std::size_t>(index)];
    }
    /// Length of the step that follows \p step, s.
    [[nodiscard]] double timestep(qint64 step) const
    {
        return states.time(step + 1) - states.time(step);
    }
    [[nodiscard]] int circleCount() const { return static_cast<int>(states.circleCount()); }
};

/// Runs the laws of \p variant for its duration.
[[nodiscard]] Observation observe(const Variant &variant);

} // namespace cradle
