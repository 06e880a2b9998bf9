// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace cradle {

/// An assignment of a program to a circle, as it was made in one update.
struct Assignment {
    enum class Field { Position, Velocity, Radius, Density };

    int circle = 0; ///< from 0
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
