// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/probe.h"
#include "tasks/judging/program_functions.h"

#include <optional>
#include <vector>

namespace cradle {

/// Looks for other values of a program with which what it does at a moment comes out right, by
/// Newton's method in steps of the values (least squares where there are more wrong numbers than
/// values).
class ValueSolver
{
public:
    /// All must live as long.
    /// \param reference  a program that is right at \p moment
    ValueSolver(const ProgramLines &program, const QString &reference, const Moment &moment,
                Aspect aspect);

    /// Whether the program does something at the moment that other values may mend.
    [[nodiscard]] bool isWrong() const;
    /// Whether these can, whatever they would have to be.
    [[nodiscard]] bool mends(const std::vector<TokenRange> &values) const;

private:
    using Numbers = std::vector<double>;

    [[nodiscard]] QString changed(const std::vector<TokenRange> &values, const Numbers &by) const;
    /// What is wrong after the moment, where each is 0 if it is right; nothing if it stops.
    [[nodiscard]] std::optional<Numbers> offOf(const QString &program) const;

    const ProgramLines &m_program;
    const Moment &m_moment;
    Aspect m_aspect;
    std::optional<World> m_right;
    std::optional<World> m_own;
};

} // namespace cradle
