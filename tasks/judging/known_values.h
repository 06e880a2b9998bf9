// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/probe.h"
#include "tasks/judging/program_functions.h"
#include "tasks/judging/scene_quantities.h"

#include <functional>
#include <optional>
#include <vector>

namespace cradle {

/// Which values that a program works out at a moment are what a right one works out, too: ways,
/// normals, masses, pushes of the scene.
class KnownValues
{
public:
    /// All must live as long.
    /// \param isSound  whether all that a line gives is known to be right
    KnownValues(const ProgramLines &program, const Moment &moment,
                std::function<bool(int)> isSound);

    /// Whether all of the values are, whenever the line is come to at the moment.
    [[nodiscard]] bool holds(int line, const std::vector<TokenRange> &values) const;

private:
    [[nodiscard]] Known kindOf(int line, const TokenRange &value) const;
    [[nodiscard]] static Stage otherThan(const Stage &stage);

    const ProgramLines &m_program;
    const Moment &m_moment;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
    std::function<bool(int)> m_isSound;
    Stage m_other;
    std::optional<World> m_before;
    std::optional<World> m_otherBefore;
};

} // namespace cradle
