// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/one_step.h"

namespace cradle {

/// A run of the student with the steps at which the reference does something else.
struct Evidence {
    const Variant *scene = nullptr;
    const Observation *run = nullptr;
    std::optional<double> restitution{}; ///< that of the student, where he may choose it
    std::vector<qint64> odd{};           ///< the reference disagrees; some of them
    std::vector<qint64> events{};        ///< it agrees, and something was hit; some of them
    std::vector<qint64> quiet{};         ///< it agrees, and nothing was hit; some of them
    std::size_t oddInAll = 0;
    std::vector<qint64> evenInAll{};
};

/// Puts the reference \p solution into every state of \p run.
/// \param restitution  in place of what the programs set, if it is given
[[nodiscard]] Evidence compareWithReference(const QString &solution, const Variant &scene,
                                            const Observation &run, OneStep::Places places,
                                            std::optional<double> restitution = std::nullopt);

/// Share of the odd steps that a mistake may fail to explain: what follows from a state that no
/// sound program reaches.
inline constexpr double unexplained = 0.05;
/// Share of the other steps that it may spoil, of the hits among them and of all: a student's slip
/// may be smaller than the known one, but what works must not be called wrong.
inline constexpr double spoilt = 0.1;
/// How many times it may do something else than the reference where the student does not, for each
/// time that the student does it, too.
inline constexpr double overdone = 3.0;

/// How well a known program explains what was seen.
struct Fit {
    std::size_t odd = 0;
    std::size_t oddMissed = 0;
    std::size_t even = 0;
    std::size_t evenMissed = 0;
    std::size_t events = 0; ///< those of the even steps in which something was hit
    std::size_t eventsMissed = 0;
    double shared = 0.0;  ///< odd steps of all that it explains
    double claimed = 0.0; ///< even steps of all in which it does something else

    [[nodiscard]] bool explains() const
    {
        return odd > 0 && static_cast<double>(oddMissed) <= unexplained * static_cast<double>(odd)
               && static_cast<double>(evenMissed) <= spoilt * static_cast<double>(even)
               && !deniesHits() && claimed <= overdone * shared;
    }
    [[nodiscard]] bool deniesHits() const
    {
        return static_cast<double>(eventsMissed) > spoilt * static_cast<double>(events);
    }
};

/// How well \p program, put into the same states, does what the student's program did.
[[nodiscard]] Fit fitOf(const QString &program, const std::vector<Evidence> &all,
                        OneStep::Places places);

} // namespace cradle
