// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"
#include "tasks/runs/variant.h"
#include "tasks/script/circle_field.h"

#include "model/run/program.h"

#include <functional>
#include <limits>

namespace cradle {

/// What a submission did in one scene. The checks see only this: positions and velocities over
/// time, and the scene that was pinned; never how they came about.
struct Observation {
    Variant variant;
    Recording states;
    std::optional<ProgramError> error{}; ///< the program stopped; the states are those before
    qint64 instructions = 0;             ///< of the program, and the work that counts as such
    std::vector<CircleField> fields{};   ///< what the program keeps with the circles at the end

    [[nodiscard]] qint64 steps() const { return states.last(); }
    [[nodiscard]] const Circle &circle(int index, qint64 step) const
    {
        return states.circles(step)[static_cast<std::size_t>(index)];
    }
    /// The same \p seconds from the start, on the straight line between the states around it; at
    /// the end where the run is shorter.
    [[nodiscard]] Circle circleAt(int index, double seconds) const;
    /// Length of every step, s, to the last bit: the difference of two times is not.
    [[nodiscard]] double timestep() const { return variant.preset.timestep; }
    [[nodiscard]] int circleCount() const { return static_cast<int>(states.circleCount()); }
};

/// Runs \p variant for its duration: \p script (a student's program) where it is not null, and
/// where it moves nothing the laws. The observation's scene is what the program made of it.
/// \param stop  asked before every step, and while a program runs; if it answers true, the states
///     end there
/// \param mostInstructions  after so many of the program the states end, too
[[nodiscard]] Observation observe(const Variant &variant, const QString *script = nullptr,
                                  const std::function<bool()> &stop = {},
                                  qint64 mostInstructions = std::numeric_limits<qint64>::max());

} // namespace cradle
