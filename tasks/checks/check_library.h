// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"

namespace cradle {

/// What is wrong with one observation, for the student.
struct Fault {
    QString message;                  ///< observed and expected, with units
    std::optional<double> expected{}; ///< in \c unit
    std::optional<double> observed{}; ///< in \c unit
    QString unit{};
    qint64 step = -1;          ///< where it first shows; −1 if nowhere in particular
    int circle = -1;           ///< that shows it, from 0; −1 if it is none alone
    bool checkStopped = false; ///< the check itself has an error: nothing is said of the run
};

/// Judges \p observation by the kind and the parameters of \p check, see
/// tasks/checks/check_kinds.h. Kinds:
///     start           values that a circle starts with
///     integrates      every free step is one of the named integrators under the named gravity
///     closed_form     x₀ + v₀t + ½gt² up to the first bounce
///     bounces         walls: v_n' = −e v_n, the part along the wall kept, at the rim, in time
///     stays_inside    never further out than one step's travel
///     together        two circles in the same state at every step
///     same_integrator two circles follow one and the same integrator
///     passes_through  two circles cross without changing
///     collides        circles 1 and 2 answer every contact by one of the named laws, in time
///     rebounds        v_n' = e v_n of the relative velocity along the line of centres, in time
///     touches         circles 1 and 2 answer every contact when the gap closes, in whatever way
///     conserves       momentum, and if asked kinetic energy, in every contact
///     after_contact   the velocities after the first contact
///     loses_energy    the first contact takes kinetic energy
///     settles         comes to rest on the floor as the reference with the same integrator does
///     ends_at         positions and velocities at a moment
///     script          what a program in Lua says of the run; see tasks/checks/check_script.h
///     bounce_heights  the n-th bounce off the floor reaches h_n = e^(2n) h_0
/// \return nullopt if nothing is wrong
[[nodiscard]] std::optional<Fault> judge(const CheckSpec &check, const Observation &observation);

} // namespace cradle
