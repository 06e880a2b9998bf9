// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace cradle {

/// An assignment of a program to a circle or to a value of the scene, as it was made.
struct Assignment {
    enum class Field { Position, Velocity, Radius, Density, Gravity, Restitution };

    int circle = 0; ///< from 0; -1 for a value of the scene
    int line = 0;   ///< from 1
    Field field = Field::Position;
    /// Another value is there than before, however near; 0 and -0 are the same. False as well where
    /// the scene keeps its value.
    bool changed = false;
    /// The lines that led there: a call in on_update, a call in what was called, and so on, without
    /// the assignment's own line; empty if on_update assigns itself. What a tail call (return f())
    /// left is not known. Of very deep calls only the last.
    std::vector<int> calls{};

    friend bool operator==(const Assignment &, const Assignment &) = default;
};

} // namespace cradle
