// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/names_at_hand.h"

namespace cradle {

/// What an aspect of a program needs, such as a normal, a distance, the place where a wall turns a
/// circle: as expressions, in the names of one function.
class Quantities
{
public:
    Quantities(const NamesAtHand &names, const QStringList &timesteps, Aspect aspect,
               Suspect suspect);

    /// What may stand in place of a whole value.
    [[nodiscard]] const QStringList &all() const { return m_all; }
    /// Those of them that are right wherever a program has them in place of \p value: masses where
    /// that is worked out of what a ball has.
    [[nodiscard]] QStringList soundFor(const QString &value) const;
    /// Coordinates of such: right where they are all that a program gives.
    [[nodiscard]] const QStringList &parts() const { return m_parts; }
    /// What may stand on a side of a question of contact in place of a value: the sum of the radii,
    /// the distance, and the square of either.
    [[nodiscard]] QStringList sides(const QString &value) const;
    /// The same in a helper that names no circle, by what every program has.
    [[nodiscard]] QStringList sidesOfScene(const QString &value) const;
    /// A value with what it may lack.
    /// \param forgottenNames  of what was worked out and is not used
    [[nodiscard]] QStringList completed(const QString &value,
                                        const QStringList &forgottenNames) const;

private:
    [[nodiscard]] static QStringList sidesFor(const QString &value, const QString &sum,
                                              const QString &length);
    void addMotion();
    void addPair(const NamedCircle &a, const NamedCircle &b);
    void addContact(const NamedCircle &a, const NamedCircle &b);
    void addResponse(const NamedCircle &a, const NamedCircle &b, const QStringList &masses);
    void addPushes(const NamedCircle &a, const NamedCircle &b, QStringList masses);
    void addHelper(const QStringList &parameters);
    void addMasses();

    const NamesAtHand &m_names;
    const QStringList &m_timesteps;
    Aspect m_aspect;
    Suspect m_suspect;
    QStringList m_all{};
    QStringList m_sound{};
    QStringList m_masses{};  ///< of balls, and volumes
    QStringList m_helpers{}; ///< of a function of one vector
    QStringList m_parts{};
    QStringList m_across{}; ///< parts of velocities that a hit leaves as they are
};

} // namespace cradle
