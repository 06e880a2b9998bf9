// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_functions.h"
#include "tasks/judging/ran_lines.h"

namespace cradle {

/// Where a program works out what it only writes down at the end of a step: who keeps positions and
/// velocities in variables or tables of his own is at fault where he changes these.
class ValueOrigin
{
public:
    /// All must live as long.
    /// \param reference  a program that is right at \p moment; empty if none is known
    /// \param isHit  at the moment something is answered that is not in the step before
    ValueOrigin(const QString &program, const QString &reference, const Moment &moment,
                const RanLines &ran, bool isHit);

    /// Whether a line writes down a position or velocity that was worked out elsewhere.
    [[nodiscard]] bool isWriteBack(int line) const;
    /// The line in which the value that \p line writes down was worked out, one assignment before:
    /// the one that changes at the moment the part of a circle that is wrong, and of a hit does not
    /// so in the step before; for several circles that of the last.
    /// \return 0 if there are several for a circle, or none
    [[nodiscard]] int of(int line) const;

private:
    /// What is wrong of a circle.
    struct Wrong {
        int circle;
        bool x;
        bool y;
    };

    /// Of each wrong part the lines that work out one of \p names and change it at the moment.
    [[nodiscard]] std::vector<std::vector<int>> originsOf(const QStringList &names,
                                                          bool isGivenByCall) const;
    [[nodiscard]] std::vector<Wrong> wrongParts(const std::optional<World> &theirs) const;
    [[nodiscard]] std::optional<World> endOf(const QString &program, qint64 step) const;
    /// The program with another value in one step: what there was before, or a little more.
    [[nodiscard]] QString withOther(const ProgramAssignment &assignment, qint64 step) const;
    [[nodiscard]] bool differs(const Wrong &part, const World &a, const World &b) const;
    [[nodiscard]] Vec2 valueOf(const World &world, int circle) const;
    [[nodiscard]] QStringList writtenAt(int line) const;
    /// Whether a hit gives a value on to another of \p names: a.v, b.v = b.v, a.v.
    [[nodiscard]] bool isExchanged(const ProgramAssignment &assignment,
                                   const QStringList &names) const;

    const QString &m_source;
    const QString &m_reference;
    const Moment &m_moment;
    const RanLines &m_ran;
    bool m_isHit;
    ProgramLines m_program;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
};

} // namespace cradle
