// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

namespace cradle {

/// One scene that a check runs: the student's laws and integrators, with some values pinned.
struct Variant {
    QString name;          ///< "preset" for the student's own scene, else what is pinned
    Preset preset{};       ///< what runs
    double duration = 1.0; ///< s
    bool pinned = false;   ///< a program cannot change what it starts with
    QStringList locked{};  ///< what a program must leave as it is; see locks.h

    friend bool operator==(const Variant &, const Variant &) = default;
};

/// The scenes that \p check runs of \p submission. Kinds of scene:
///     own         the student's own scene, at each of \c timesteps
///     flight      the check's circles thrown into the middle of the square
///     directions  each of the check's circles at the walls, in \c count directions, while the
///                 others move on where nothing meets them; without gravity one of them slowly
///     corners     the same straight at the corners and just beside them
///     encounters  circles 1 and 2 thrown so that they meet, from \c count angles, up to
///                 \c offset · (r₁ + r₂) off centre
///     parting     circles 1 and 2 overlap and move apart already
///     slow        the check's circles come slowly to the floor and the ceiling, at many moments of
///                 a step, and to the walls beside
///     drop        the check's circles fall onto the floor
/// Angles are counted from the x axis and spread over \c angles, all round if not given.
/// All but \c own pin square, positions, velocities, radii, densities, gravity (none if not given)
/// and restitution (1 if not given) and keep no circles beyond those that the check needs.
/// The same \p seed gives the same scenes; a \c seed of the check's own takes its place.
/// \pre submission has the check's circles
[[nodiscard]] std::vector<Variant> makeVariants(const Preset &submission, const CheckSpec &check,
                                                qint64 seed);

} // namespace cradle
