// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/pile.h"

namespace cradle {

/// Two bodies of a pile so near that they may meet in the step.
struct NearPair {
    Pile::Body a = 0;
    Pile::Body b = 0;    ///< or a wall
    double met = -1.0;   ///< when they would meet, s into the step; none if negative
    Vec2 normal{};       ///< from a to b, when they would meet or else at the start
    double gap = 0.0;    ///< along it at the start, m
    double speed = 0.0;  ///< at which they meet, m/s
    bool active = false; ///< is a contact
};

/// How far each circle of a pile may come in a step as far as its speeds tell, m.
[[nodiscard]] std::vector<double> foreseenWays(const Pile &pile);

/// All pairs that can come together while no circle goes farther than its way (m). The normal of
/// each is that at which they would meet if they flew straight on at what gravity makes of their
/// speeds: a line across it that both keep to for the step keeps them apart.
/// \param pairs  overwritten
void findNearPairs(const Pile &pile, std::span<const double> ways, std::vector<NearPair> &pairs);

} // namespace cradle
