// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_pair.h"

#include <QString>

namespace cradle {

/// A hit of two equal circles with the answer that is right for it.
struct EqualHit {
    const PairHit &hit;
    PairVelocities in;    ///< before
    PairVelocities right; ///< after, by the reference
};

/// An answer to hits of equal circles that students write, and what is to be said of it.
struct ResponseLaw {
    PairVelocities (*answer)(const EqualHit &);
    QString headline;
    QString body;
    bool isForEvery = false; ///< said only where hits of other masses and e follow it, too
    bool isOfE = false;      ///< said of the e that was tried, where others do not follow it
};

/// The known ones, the most particular first.
[[nodiscard]] std::vector<ResponseLaw> knownResponses();

/// What changes hands.
[[nodiscard]] std::vector<ResponseLaw> exchangeLaws();

/// Those with another direction than the line of centres, or a length other than 1.
[[nodiscard]] std::vector<ResponseLaw> directionLaws();

/// What is right, with both pushes \p factor times as large.
[[nodiscard]] PairVelocities pushed(const EqualHit &h, double factor);

/// The hits that two programs had along the same line.
[[nodiscard]] std::vector<EqualHit> comparableHits(const std::vector<PairHit> &own,
                                                   const std::vector<PairHit> &right);

/// Whether \p law gives what the student's circles did in all of \p hits.
[[nodiscard]] bool follows(const ResponseLaw &law, const std::vector<EqualHit> &hits);

/// Whether two answers are the same but for what a short step blurs.
/// \param gain  by how much the faster of the two left faster than the faster one came
[[nodiscard]] bool isSameAnswer(const PairVelocities &a, const PairVelocities &b,
                                double gain = 0.0);

} // namespace cradle
