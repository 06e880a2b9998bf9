// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_functions.h"

namespace cradle {

/// How a program names what a circle has: `a.position`, `s.p`, `circles[1].radius`.
struct NamedCircle {
    QString position{};
    QString velocity{};
    QString radius{};
    QString density{};
};

/// The circles that a function of a program has names for.
class NamesAtHand
{
public:
    /// Of the function in which \p line stands.
    /// \param assignments, functions  all of \p program
    NamesAtHand(const ProgramLines &program, const std::vector<ProgramAssignment> &assignments,
                const std::vector<ProgramFunction> &functions, int line);

    /// Those with names of their own, in the order in which they are named.
    [[nodiscard]] const std::vector<NamedCircle> &circles() const { return m_circles; }
    /// Two circles; those of the scene where the function is given nothing and names none. Nothing
    /// where it is about one.
    [[nodiscard]] std::optional<std::pair<NamedCircle, NamedCircle>> pair() const;
    /// As every program has them: circles[1], circles[2].
    [[nodiscard]] static std::pair<NamedCircle, NamedCircle> pairOfScene();
    /// What radii are called, also those of no named circle.
    [[nodiscard]] QStringList radii() const;
    /// Variables that are called as normals are.
    [[nodiscard]] const QStringList &normals() const { return m_normals; }
    /// What a hit takes of the closing speed: 1 + e, or 2 where the program knows no e.
    [[nodiscard]] const QString &rebound() const { return m_rebound; }
    /// Variables that are worked out of a radius.
    [[nodiscard]] const QStringList &ofRadius() const { return m_ofRadius; }
    [[nodiscard]] const QStringList &parameters() const { return m_parameters; }
    /// What two masses are called; nothing if there are not two.
    [[nodiscard]] const QStringList &masses() const { return m_masses; }

private:
    void nameCircles(const ProgramLines &program, const std::vector<ProgramAssignment> &assignments,
                     const std::vector<std::size_t> &names, const ProgramFunction *function,
                     int line);
    void nameNumbers(const ProgramLines &program, const std::vector<std::size_t> &names);
    std::vector<NamedCircle> m_circles{};
    QString m_rebound{};
    QStringList m_masses{};
    QStringList m_radii{}; ///< variables
    QStringList m_normals{};
    QStringList m_ofRadius{};
    QStringList m_parameters{}; ///< of the function
};

} // namespace cradle
