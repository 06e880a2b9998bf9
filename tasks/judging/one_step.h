// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"
#include "tasks/script/student_script.h"

namespace cradle {

/// Compares a known program with a student's run one step at a time: before every step the program
/// is put into the student's own state, so that neither an earlier drift nor another way of
/// handling a wall hides what it does.
class OneStep
{
public:
    /// How near the places must be where nothing was hit.
    enum class Places {
        Exact, ///< the same integrator
        Free,  ///< that of any integrator
        Only   ///< the places alone count, velocities do not
    };

    /// \param scene   what the student's run started from, before any program touched it
    /// \param restitution  in place of what the program sets, if it is given
    OneStep(const QString &program, const Variant &scene,
            std::optional<double> restitution = std::nullopt);

    /// Whether the program runs in that scene at all.
    [[nodiscard]] bool runs() const { return m_runs; }
    /// The numbers that it keeps with the circles.
    [[nodiscard]] std::vector<CircleField> fields() const { return m_program.ownFields(); }

    /// Whether one update from state \p k of \p o makes state k + 1, as far as it can be told: the
    /// velocities after a hit may belong to any normal that is honest in discrete steps.
    [[nodiscard]] bool agrees(const Observation &o, qint64 k, Places places);

private:
    using Circles = std::vector<Circle>;

    [[nodiscard]] std::optional<Circles> update(const World &world, double dt);
    [[nodiscard]] bool isFarFrom(const Observation &o, qint64 k, const Circles &made) const;
    [[nodiscard]] bool agreesFreely(const Observation &o, qint64 k, const Circles &made,
                                    std::size_t i, Places places) const;
    [[nodiscard]] bool agreesAtSomeNormal(const Observation &o, qint64 k);

    StudentScript m_program;
    bool m_runs = false;
};

} // namespace cradle
