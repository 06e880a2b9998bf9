// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_pair.h"
#include "tasks/judging/response_laws.h"

#include <QCoreApplication>

namespace cradle {

struct ResponseText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A finding on how a hit is answered, shown at \p hit.
[[nodiscard]] LawDeviation responseDeviation(const QString &headline, const QString &body,
                                             const PairHit &hit, Suspect suspect = Suspect::Answer);

/// What a right program makes of circles that come with \p in. Where one impulse answers them, it
/// grows with the closing speed; what it makes of its own arrival, \p right, is taken over else.
[[nodiscard]] PairVelocities rightFor(const PairVelocities &in, const PairHit &right);

/// What came, what left, and what is right, in words.
/// \param alongAlone  of the parts across another finding tells
[[nodiscard]] QString describeHit(const PairHit &hit, const PairHit &right,
                                  bool alongAlone = false);

/// Of exponents, and of ratios of masses.
inline constexpr double ratioBlur = 0.01;
/// To what a reader would call it: 3 for 2.997.
[[nodiscard]] double roundedExponent(double p);

/// Whether all came along the line of centres, so that nothing depends on where exactly they met.
[[nodiscard]] bool isHeadOn(const PairHit &hit);

/// Whether a hit changed the velocity of one circle alone.
[[nodiscard]] bool isOnePushed(const PairHit &hit);

/// How many times as heavy circle 2 is, by what the pushes did: |Δv₁| / |Δv₂|; nothing if they
/// are not opposite. Where one alone is pushed, as its share of what parts them tells.
[[nodiscard]] std::optional<double> massRatio(const PairHit &hit);

/// m₂/m₁ of balls: (r₂/r₁)³ ρ₂/ρ₁.
[[nodiscard]] inline double ballRatioOf(const Meeting &m)
{
    return std::pow(m.radius2 / m.radius1, 3) * m.density2 / m.density1;
}
/// The same by the push along the line of centres on one circle, from 0: its share of what parts
/// two circles is that of the other in both masses.
[[nodiscard]] std::optional<double> massRatioFor(const PairHit &hit, int circle);

/// The exponents p and s in mass ∝ r^p ρ^s that the hits of a program follow; nothing where they
/// follow none, or it was not asked for.
struct MassExponents {
    /// \param circle  from 0: as the push on it alone tells; none: as both tell
    explicit MassExponents(const MeasuredPair &pair, std::optional<int> circle = {});
    /// m₂/m₁ of such circles; where an exponent is not known, as for balls.
    [[nodiscard]] double ratioOf(const Meeting &meeting) const;

    std::optional<double> radius;
    std::optional<double> density;
};

/// A mass ratio other than 1 that equal circles have in every hit.
[[nodiscard]] std::optional<double> fixedMassRatio(const MeasuredPair &pair);

/// Where the masses differ, that the two pushes are not those of one impulse: one circle alone
/// leaves as it should, each has the other's share of the rebound, or momentum is lost.
[[nodiscard]] std::optional<LawDeviation> sharedPushDeviation(const MeasuredPair &own,
                                                              const MeasuredPair &right);

/// Where any masses are allowed, that circles of two sizes come out right with none: neither do
/// their parts along the line of centres change hands, nor are they pushed as balls.
[[nodiscard]] std::optional<LawDeviation> sizeDeviation(const MeasuredPair &own,
                                                        const MeasuredPair &right);

/// The answer in which the masses of balls stand in a wrong place, or that gives each circle what
/// belongs to the other, if all hits of \p own follow it and two are of different masses.
[[nodiscard]] std::optional<ResponseLaw> unevenLaw(const MeasuredPair &own,
                                                   const MeasuredPair &right);
/// That they do.
[[nodiscard]] std::optional<LawDeviation> unevenDeviation(const MeasuredPair &own,
                                                          const MeasuredPair &right);

/// That the masses are numbers, or are worked out in two ways; nothing if they are of the circles.
[[nodiscard]] std::optional<LawDeviation> numberedMasses(const MeasuredPair &own);

/// A hit of two circles that are not alike in which |Δv₁| + |Δv₂| along the line of centres is
/// another part of (1 + e) u than where they are, with the same e; null if there is none. No masses
/// make it: their shares, m₂/(m₁ + m₂) and m₁/(m₁ + m₂), add up to 1.
[[nodiscard]] const PairHit *unsharedHit(const MeasuredPair &own);
/// Whether |Δv₁| + |Δv₂| in \p hit is another part of (1 + e) u than 1, by opposite pushes.
[[nodiscard]] bool isUnshared(const PairHit &hit);
/// That this is so, where it is right for circles that are alike.
[[nodiscard]] LawDeviation unsharedDeviation(const PairHit &hit);

/// In what the masses of \p own are not those of \p right.
/// \param areEqualsRight  hits of equal circles are: else only clear powers are told
[[nodiscard]] std::vector<LawDeviation>
massDeviations(const MeasuredPair &own, const MeasuredPair &right, bool areEqualsRight);

/// The same where the push on one circle or both is wrong for equal masses, too: as the push along
/// the line of centres tells on one that leaves equal hits as it should.
[[nodiscard]] std::vector<LawDeviation> massDeviationsBeside(const MeasuredPair &own,
                                                             const MeasuredPair &right);

/// How e acts on the rebound of a program.
struct ReboundReading {
    std::vector<LawDeviation> deviations{};
    bool explainsElastic = false; ///< also what is wrong where e is 1
};

/// In what e acts on \p own otherwise than on \p right.
[[nodiscard]] ReboundReading reboundDeviations(const MeasuredPair &own, const MeasuredPair &right);

} // namespace cradle
