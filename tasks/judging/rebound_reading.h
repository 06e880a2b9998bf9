// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_pair.h"

#include <functional>

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

inline constexpr double reboundBlur = 0.02; ///< of e

/// What comes out with some e.
using LawOfE = std::function<double(double)>;

/// Whether \p part of \p all is what \p law makes of their e; where that is no number, anything is.
[[nodiscard]] bool followEach(const std::vector<Rebound> &all, double Rebound::*part,
                              const LawOfE &law);

/// Whether the push on \p circle, from 1, has the rebound of \p law where the masses differ.
[[nodiscard]] bool isOfMasses(const LawOfE &law, int circle, const MeasuredPair &own,
                              const MeasuredPair &right);

/// A push that grows evenly with e; it is multiplied by 1 + e if it is right.
struct PushLine {
    double without = 1.0; ///< with e = 0
    double perE = 1.0;
};
/// That of both circles, whatever their masses are; nothing if it is none, does not depend on e, or
/// is 1 + e times a number.
/// \param elastic  the rebounds with the greatest e, \p all those with the others
[[nodiscard]] std::optional<PushLine> lineOfPush(const MeasuredPair &own,
                                                 const std::vector<Rebound> &all,
                                                 const std::vector<Rebound> &elastic);

/// By how little a push changes what two have, where it is next to nothing; else empty.
[[nodiscard]] QString faintPush(const PairHit &hit);

} // namespace cradle
