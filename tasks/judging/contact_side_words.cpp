// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

class SideJudge : ContactComparison
{
public:
    using ContactComparison::ContactComparison;

    [[nodiscard]] std::optional<SideDeviation> judge()
    {
        if (!findSide())
            return std::nullopt;
        return SideDeviation{std::move(m_found.front()), m_isOfVelocity};
    }

private:
    /// A side of circle 1: the sign of one coordinate of the line of centres.
    struct Side {
        QString headline;
        QString moving; ///< the headline where it is the velocity that must point there
        double (*coordinate)(double angle);
        double sign;
    };

    static std::vector<Side> sides()
    {
        const auto cosine = [](double angle) { return std::cos(angle); };
        const auto sine = [](double angle) { return std::sin(angle); };
        return {
            {ContactText::tr("Hits come out right only where circle 2 is to the right of circle 1"),
             ContactText::tr(
                 "Hits are answered only where circle 1 moves to the right of circle 2"),
             cosine, 1.0},
            {ContactText::tr("Hits come out right only where circle 2 is to the left of circle 1"),
             ContactText::tr("Hits are answered only where circle 1 moves to the left of circle 2"),
             cosine, -1.0},
            {ContactText::tr("Hits come out right only where circle 2 is above circle 1"),
             ContactText::tr("Hits are answered only where circle 1 moves upward beside circle 2"),
             sine, 1.0},
            {ContactText::tr("Hits come out right only where circle 2 is below circle 1"),
             ContactText::tr(
                 "Hits are answered only where circle 1 moves downward beside circle 2"),
             sine, -1.0}};
    }

    /// A hit with circle 2 on the other side that is answered because circle 1 moves to this one;
    /// null where the side counts, or where that was not looked at.
    [[nodiscard]] const PairHit *answeredByVelocity(const Side &side) const
    {
        const PairHit *found = nullptr;
        for (const PairHit &hit : m_own.askew) {
            const Vec2 n{std::cos(hit.meeting.degrees * std::numbers::pi / 180.0),
                         std::sin(hit.meeting.degrees * std::numbers::pi / 180.0)};
            const PairVelocities &v = hit.meeting.velocities;
            const Vec2 u = hit.meeting.closing() * n + (v.across1 - v.across2) * perpendicular(n);
            const double place =
                side.sign * side.coordinate(hit.meeting.degrees * std::numbers::pi / 180.0);
            const double way = side.sign * side.coordinate(std::atan2(u.y, u.x));
            if (place * way > 0.0)
                continue; // it moves to where the other is
            if (hit.isMet() != (way > 0.0))
                return nullptr;
            found = hit.isMet() ? &hit : found;
        }
        return found;
    }

    void addVelocitySide(const Side &side, const PairHit &missed, const PairHit &met)
    {
        add(side.moving,
            ContactText::tr("With their line of centres, from 1 to 2, at %1° they came nearer with "
                            "%2 m/s and ran into each other; at %3° they are answered, as circle 1 "
                            "moves that way across the line. Whether two come nearer is told by "
                            "the part of one velocity relative to the other along the line of "
                            "centres, not by its x or y.")
                .arg(brief(missed.meeting.degrees),
                     brief(missed.slowness * missed.meeting.closing()), brief(met.meeting.degrees)),
            missed);
        m_isOfVelocity = true;
    }

    /// Whether a meeting from far is answered about as it should be, in time.
    [[nodiscard]] bool isRight(std::size_t contact) const
    {
        const PairHit &own = m_own.contacts[contact];
        const PairHit &right = m_right.contacts[contact];
        // The line of centres turns within the step of the hit.
        const double slack = 0.2 * own.meeting.closing();
        return isInTime(own)
               && length(own.left1 - right.left1) + length(own.left2 - right.left2) < slack;
    }

    /// Whether the hits on one side of circle 1 come out right, and no others; among these some
    /// are not answered in time.
    bool findSide()
    {
        const auto &all = m_own.contacts;
        const auto late = std::find_if_not(all.begin(), all.end(), isInTime);
        const auto isAskew = [](const PairHit &h) {
            return isInTime(h) && !pushesAlongCentres({h});
        };
        if (late == all.end() || std::any_of(m_own.equals.begin(), m_own.equals.end(), isAskew)
            || !std::all_of(m_right.contacts.begin(), m_right.contacts.end(), isInTime))
            return false;
        for (const Side &side : sides()) {
            const PairHit *good = nullptr;
            bool splits = true;
            for (std::size_t i = 0; i < all.size(); ++i) {
                const double angle = all[i].meeting.degrees * std::numbers::pi / 180.0;
                const double place = side.sign * side.coordinate(angle);
                // One hardly to that side differs hardly from one to the other.
                if (std::abs(place) < 0.1)
                    continue;
                const bool isThere = place > 0.0;
                splits = splits && isThere == isRight(i);
                good = isThere && !good ? &all[i] : good;
            }
            if (!splits || !good)
                continue;
            const auto right = m_right.contacts.begin() + (late - all.begin());
            if (const PairHit *moves = answeredByVelocity(side)) {
                addVelocitySide(side, late->answered ? *late : withStepOf(*late, *right), *moves);
                return true;
            }
            add(side.headline,
                ContactText::tr("With their line of centres, from 1 to 2, at %1° they came nearer "
                                "with %2 m/s and ran into each other; at %3° they are answered "
                                "when they touch. Look at what changes its sign from one side to "
                                "the other: a difference of two positions, an angle that is "
                                "worked out from it, or one part of a velocity.")
                    .arg(brief(late->meeting.degrees),
                         brief(late->slowness * late->meeting.closing()),
                         brief(good->meeting.degrees)),
                late->answered ? *late : withStepOf(*late, *right), Suspect::Formula);
            m_found.back().topic = Topic::Direction;
            return true;
        }
        return false;
    }

    bool m_isOfVelocity = false;
};

} // namespace

std::optional<SideDeviation> sideDeviation(const MeasuredPair &own, const MeasuredPair &right,
                                           const Ground &ground)
{
    return SideJudge(own, right, ground).judge();
}

} // namespace cradle
