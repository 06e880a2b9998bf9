// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

namespace cradle {

/// What the checks of a step ask for, and in which scenes. A law is measured on this ground only:
/// a program may do what it likes where nobody asks.
struct Ground {
    /// What is asked of the free flight of one circle.
    struct Flight {
        bool asked = false;
        /// c in x' = x + v h + c a h²: 0 Euler, 1 symplectic Euler, ½ Verlet and Runge-Kutta 4.
        std::vector<double> shares{};
        bool isAnyMethod = false; ///< none is named: any that is right, in smaller steps, too
    };
    /// Least and greatest of a quantity; the same twice where it is not varied.
    struct Range {
        double low = 0.0;
        double high = 0.0;

        [[nodiscard]] bool isVaried() const { return high > low; }
        void include(double value);
    };
    struct Walls {
        std::vector<int> circles{}; ///< from 0; none: nothing is asked
        Vec2 gravity{};             ///< m/s²
        std::vector<double> restitutions{};
        Range radii{0.2, 0.2}; ///< m
    };
    struct Pair {
        bool asked = false;
        bool oblique = false;  ///< hits off centre, too
        bool bothMove = false; ///< circle 2 moves before the hit, too
        bool masses = false;   ///< what a hit does with unequal circles; else only when they meet
        std::vector<double> restitutions{};
        Range radii{0.2, 0.2};     ///< m
        Range densities{7.8, 7.8}; ///< 1000 kg/m³
        /// How far from the middle they meet, of what an empty stage allows: less where walls turn
        /// circles that are far from them.
        double room = 1.0;
    };

    /// \param own  the student's preset: laws and integrators are his
    Ground(const Task &task, const Preset &own);

    /// An empty stage with the student's laws, without gravity, e = 1, circles at rest and out of
    /// each other's way. All numbers may be changed.
    [[nodiscard]] Preset stage() const;

    Preset own{};
    std::vector<Flight> flights{};   ///< of every circle that a check looks at
    std::vector<Vec2> gravities{};   ///< of the scenes of all checks, the own one first, m/s²
    std::vector<double> timesteps{}; ///< of the scenes of all checks, s
    bool sameIntegrator = false;     ///< whichever, but one for all
    Walls walls{};
    Pair pair{};
};

} // namespace cradle
