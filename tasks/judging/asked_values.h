// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_functions.h"

namespace cradle {

/// A value that a question compares with a number, as in `if gap < 0`.
struct AskedValue {
    int line = 0;         ///< where it is worked out
    bool isReach = false; ///< of a radius
};

/// What the questions of a program ask.
class AskedValues
{
public:
    /// \param program  must live as long
    explicit AskedValues(const ProgramLines &program);

    /// Local values that \p line compares with a number and that were worked out above it.
    [[nodiscard]] std::vector<AskedValue> of(int line) const;
    /// Whether \p line compares a distance: what is worked out of a radius.
    [[nodiscard]] bool asksReach(int line) const;
    /// The line in which a local value that \p line takes is worked out, with a radius in it or
    /// without one; 0 if there is none, or several.
    [[nodiscard]] int valueBehind(int line, bool isReach) const;
    /// Whether it asks for several things.
    [[nodiscard]] bool isJoined(int line) const;

private:
    [[nodiscard]] bool isOfRadius(std::size_t from, std::size_t to) const;
    [[nodiscard]] std::optional<AskedValue> valueAt(std::size_t i, int line) const;

    const ProgramLines &m_program;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
    QStringList m_radii; ///< names that a radius is copied to
};

} // namespace cradle
