// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_pair.h"

namespace cradle {

/// How two equal circles came out of a hit with some e.
struct Rebound {
    double e = 1.0;
    /// The e that fits the push of each: |Δv| / (s u) − 1, with the closing speed u and the share
    /// s that is the mass of the other of both masses.
    double first = 1.0;
    double second = 1.0;
    double across1 = 1.0; ///< part across after / before
    double across2 = 1.0;
    double sum = 1.0; ///< of both parts along the normal, after / before
};

/// \param heavy  how many times as heavy circle 2 is for the program
[[nodiscard]] Rebound reboundOf(const PairHit &hit, double heavy = 1.0);

} // namespace cradle
