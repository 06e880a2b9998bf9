// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/contact_tests.h"
#include "tasks/judging/deviation.h"
#include "tasks/judging/meeting_division.h"

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
    [[nodiscard]] static bool meetsAny(const std::vector<PairHit> &hits);
    /// Whether equal circles leave a hit as they should: what comes later is judged by that.
    [[nodiscard]] bool answersRightly() const;
    [[nodiscard]] bool isDirectionWrong() const;
    [[nodiscard]] static bool isInTime(const PairHit &h)
    {
        return h.isMet() && h.fits(h.meeting.sum());
    }
    /// How fast those that are thrown come nearer at most, m/s.
    [[nodiscard]] double fastestThrown() const;
    /// \p hit, which no step answered, at about the step in which it should be.
    [[nodiscard]] static PairHit whereTheyTouch(PairHit hit);

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    const Ground &m_ground;
    std::vector<LawDeviation> m_found{};
};

/// That some meetings are answered and others are not: by what divides them.
class DividedMeetings : ContactComparison
{
public:
    DividedMeetings(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

    /// Whether some are missed, and it counts from where they come, or where they meet: then what
    /// they have in common besides is no law.
    [[nodiscard]] bool isOfWay() const;
    /// \param isKnown  something else was found that may explain it
    [[nodiscard]] std::optional<LawDeviation> said(bool isKnown);

private:
    [[nodiscard]] bool isRight(const PairHit &hit) const;
    [[nodiscard]] bool isHardlyMissed() const;
    void tell();
    /// How many of them come out right, and which.
    [[nodiscard]] QString counted() const;
    [[nodiscard]] static const PairHit &plainest(const std::vector<const PairHit *> &hits);

    /// Whether the push of \p hit would be none, as the program answers others: nothing is missed.
    [[nodiscard]] bool isPushless(const PairHit &hit) const;

    std::vector<PairHit> m_all{};
    std::optional<MeetingDivision> m_division{};
    std::vector<const PairHit *> m_answered{};
    std::vector<const PairHit *> m_missed{};
};

/// How they came, where, and what circles they are, as far as a step varies that.
[[nodiscard]] QString describeMeeting(const PairHit &hit, const Ground &ground,
                                      const std::optional<MeetingDivision> &division);

/// That none is answered in time where some should be, or places or circles that part are.
/// \return nothing where meetings are answered as such, no deviation where that is all
[[nodiscard]] std::optional<std::vector<LawDeviation>>
noneAnswered(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

/// That they answer at another distance than that of rims which touch.
[[nodiscard]] std::vector<LawDeviation>
distanceDeviations(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground);

/// That the places of the two are not of the same moment where their distance is asked for: how far
/// apart they are answered depends on what they fly in a step.
[[nodiscard]] std::optional<LawDeviation> momentsDeviation(const std::vector<PairHit> &chases);

/// That of two meetings which touch early and late in a step one is not answered.
[[nodiscard]] std::optional<LawDeviation> missedInStep(const MeasuredPair &own,
                                                       const MeasuredPair &right);

/// Which of the meetings that are looked at.
enum class Meetings {
    Parting, ///< of circles that have met already
    Later,   ///< after a first hit
    SlowOrFast,
    FastAlone, ///< where none of those that come as usual is answered
};
/// That some of them are not answered, or those that part are.
[[nodiscard]] std::vector<LawDeviation> meetingDeviations(Meetings which, const MeasuredPair &own,
                                                          const MeasuredPair &right,
                                                          const Ground &ground);

} // namespace cradle
