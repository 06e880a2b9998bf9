// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/flight_scenes.h"

/// Who moves a circle that does not fly by itself.
namespace cradle::flights {

/// The circle whose velocity moves circle \p i, where its own does not; -1 if none does.
/// \param rest  the flight of those that start at rest
[[nodiscard]] int leaderOf(const QString *program, const Ground &ground, Vec2 gravity, double h,
                           std::size_t i, const Steps &rest);

/// Whether circle \p i is nearer to where circle \p j was than to where itself was, one step later.
[[nodiscard]] bool startsFrom(const Steps &run, std::size_t j, std::size_t i);

/// The circle beside whose start circle \p i is one step later, far from its own, in both runs; -1
/// if it is none.
[[nodiscard]] int placedBy(const Steps &first, const Steps &second, std::size_t i);

/// The circle whose velocity circle \p i has one step later, but for what it has from rest; -1 if
/// it is none.
[[nodiscard]] int borrowedBy(const Steps &rest, const Steps &first, const Steps &second,
                             std::size_t i);

/// The circle at whose place circle \p i is after the first step, though it started elsewhere; -1
/// if it is none.
[[nodiscard]] int followedBy(const Steps &steps, std::size_t i);

} // namespace cradle::flights
