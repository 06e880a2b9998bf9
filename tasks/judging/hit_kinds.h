// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/condition_comparison.h"
#include "tasks/judging/meeting_division.h"
#include "tasks/judging/response_laws.h"

namespace cradle {

/// What was found of a few hits, told of no more than it holds for: by first hits of many kinds,
/// each in a run of its own.
class HitKinds : ConditionComparison
{
public:
    explicit HitKinds(const ConditionComparison &comparison)
        : ConditionComparison(comparison)
    {
    }

    /// Whether they are divided by where the other circle is.
    [[nodiscard]] bool areOfSide() const;
    /// \param found  what is said of the response
    [[nodiscard]] std::vector<LawDeviation> judge(std::vector<LawDeviation> found);

private:
    using Kinds = std::vector<JudgedMeeting>;

    [[nodiscard]] Kinds kinds() const;
    [[nodiscard]] const PairHit &goodOf(const PairHit &hit) const;
    [[nodiscard]] bool areEqualsRight() const;
    [[nodiscard]] std::optional<MeetingDivision> divisionOf(const Kinds &hits) const;

    [[nodiscard]] std::vector<EqualHit> besideRight(const Kinds &hits) const;
    [[nodiscard]] std::optional<ResponseLaw> saidLaw() const;
    [[nodiscard]] bool isLawOf(const Kinds &hits) const;
    [[nodiscard]] bool areMasses(const Kinds &hits) const;
    [[nodiscard]] bool areShares(const Kinds &hits) const;
    [[nodiscard]] bool isOfOneCircle(const PairHit &hit) const;
    [[nodiscard]] bool isOfPush(const PairHit &hit) const;
    [[nodiscard]] bool isOfAcross(const PairHit &hit) const;
    [[nodiscard]] bool isOfMost(const Kinds &hits) const;
    [[nodiscard]] QString countOf(const Kinds &hits,
                                  const std::optional<MeetingDivision> &division) const;
    void limit(const Kinds &hits);
    static void limitTo(LawDeviation &found, const QString &text);
    void judge();
    void judgeAllWrong(const Kinds &hits);
    [[nodiscard]] bool isWrongWith(double restitution) const;
    [[nodiscard]] Kinds withLosses() const;
    void judgeRestitution();
    void limitRestitution(const Kinds &hits);
    void limitToE(bool isOfMasses);
    [[nodiscard]] bool areOtherMasses(const Kinds &hits);
    [[nodiscard]] std::optional<ResponseLaw> lawOf(const Kinds &hits) const;
    [[nodiscard]] const PairHit &clearlyWrong(const Kinds &all) const;
    [[nodiscard]] LawDeviation kindsDeviation(const Kinds &all,
                                              const std::optional<MeetingDivision> &division) const;
};

/// Whether two circles have the same radius and density.
[[nodiscard]] constexpr bool areAlike(const Meeting &m)
{
    return m.radius1 == m.radius2 && m.density1 == m.density2;
}

/// How many of \p hits come out right.
[[nodiscard]] std::ptrdiff_t rightOf(const std::vector<JudgedMeeting> &hits);

/// Whether two answers to \p hit are the same, as seen from how fast they came.
[[nodiscard]] bool isSameAnswerTo(const PairHit &hit, const PairVelocities &a,
                                  const PairVelocities &b);

} // namespace cradle
