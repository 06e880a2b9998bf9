// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/contact_tests.h"
#include "tasks/judging/deviation.h"

namespace cradle {

/// The meetings of a program's circles beside those of the reference, and what is found of them.
class ContactComparison
{
public:
    ContactComparison(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
    {
    }

protected:
    void add(const QString &headline, const QString &body, const PairHit &hit,
             Suspect suspect = Suspect::Question);

    [[nodiscard]] static bool answersAny(const std::vector<PairHit> &hits);
    /// Whether equal circles leave a hit as they should: what comes later is judged by that.
    [[nodiscard]] bool answersRightly() const;
    /// Whether all pushes act along the line of centres.
    [[nodiscard]] static bool pushesAlongCentres(const std::vector<PairHit> &hits);
    [[nodiscard]] bool isDirectionWrong() const;
    [[nodiscard]] static bool isInTime(const PairHit &h)
    {
        return h.isMet() && h.fits(h.meeting.sum());
    }
    /// \p hit, which no step answered, at about the step in which it should be.
    [[nodiscard]] static PairHit withStepOf(PairHit hit, const PairHit &answered);
    /// The same for one that nothing is compared with.
    [[nodiscard]] static PairHit whereTheyTouch(PairHit hit);

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    const Ground &m_ground;
    std::vector<LawDeviation> m_found{};
};

/// That hits come out right on one side of circle 1 alone.
struct SideDeviation {
    LawDeviation said;
    bool isOfVelocity = false; ///< it counts to which side circle 1 moves
};
[[nodiscard]] std::optional<SideDeviation>
sideDeviation(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

/// That they answer at another distance than that of rims which touch.
[[nodiscard]] std::vector<LawDeviation>
distanceDeviations(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

/// Which of the meetings that are looked at.
enum class Meetings {
    OfEqualCircles, ///< by who comes to whom, and whether those that part are answered
    Later,          ///< after a first hit
    FromAllAround,  ///< and slow ones
};
/// That some of them are not answered, or those that part are.
[[nodiscard]] std::vector<LawDeviation> meetingDeviations(Meetings which, const MeasuredPair &own,
                                                          const MeasuredPair &right,
                                                          const Ground &ground);

} // namespace cradle
