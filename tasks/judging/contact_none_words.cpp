// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cradle {

namespace {

bool isAnyInTime(const std::vector<PairHit> &hits)
{
    return std::any_of(hits.begin(), hits.end(), [](const PairHit &hit) { return hit.isInTime(); });
}

/// Judges a program of which no meeting is answered in time, or something else than meetings.
class NoneAnswered : ContactComparison
{
public:
    using ContactComparison::ContactComparison;

    [[nodiscard]] std::optional<std::vector<LawDeviation>> judge()
    {
        if (findOpposite() || findNever() || findParting())
            return std::move(m_found);
        return std::nullopt;
    }

private:
    void take(std::vector<LawDeviation> found)
    {
        m_found.insert(m_found.end(), std::make_move_iterator(found.begin()),
                       std::make_move_iterator(found.end()));
    }

    /// Those that are far apart and opposite about the origin are answered, and hardly any where
    /// they touch.
    bool findOpposite()
    {
        const auto inTime = std::count_if(m_own.contacts.begin(), m_own.contacts.end(), isInTime);
        if (!m_own.opposite || !answersAny(m_right.contacts)
            || 2 * inTime >= std::ssize(m_own.contacts))
            return false;
        const PairHit &hit = *m_own.opposite;
        const std::vector<PresetCircle> &circles = hit.stage.preset.circles;
        add(ContactText::tr("The circles are answered far apart, not where they touch"),
            ContactText::tr("At %1 and %2 m, opposite each other about the middle of the square, "
                            "they were answered with their centres %3 m apart.")
                    .arg(brief(circles[0].body.position), brief(circles[1].body.position),
                         brief(hit.before))
                + QLatin1Char(' ')
                + ContactText::tr("Of %1 meetings tried, %n were answered in time.", nullptr,
                                  static_cast<int>(inTime))
                      .arg(m_own.contacts.size())
                + QLatin1Char(' ')
                + ContactText::tr("Look at whether the two places are subtracted: their sum is not "
                                  "the way from one to the other."),
            hit, Suspect::Reach);
        return true;
    }

    bool findNever()
    {
        // With e = 1 a hit may come to nothing that is one with another e, and elsewhere or of
        // other circles there may be one.
        const bool own = answersAny(m_own.contacts) || isAnyInTime(m_own.varied)
                         || (!answersAny(m_own.equals) && answersAny(m_own.rebounds));
        const bool right = answersAny(m_right.contacts);
        if (!own && !right && findHeld())
            return true;
        if (own == right || m_own.contacts.empty())
            return !own;
        PairHit hit = m_own.contacts.front();
        hit.step = right ? m_right.contacts.front().step : hit.step;
        if (right)
            take(meetingDeviations(Meetings::FastAlone, m_own, m_right, m_ground));
        if (!m_found.empty())
            return true;
        if (right && m_own.own && m_own.own->answered) {
            findOwnAlone();
            return true;
        }
        const auto held = std::find_if(m_own.contacts.begin(), m_own.contacts.end(),
                                       [](const PairHit &h) { return h.isHeld(); });
        if (right && held != m_own.contacts.end() && held->leaper >= 0)
            add(ContactText::tr("A hit changes the places of the circles, not their velocities"),
                ContactText::tr("When they touched, circle %1 was put to %2 m, far from where it "
                                "came from, and both kept their velocities. A hit changes "
                                "velocities; each circle stays near its own way.")
                    .arg(held->leaper + 1)
                    .arg(brief(held->landed)),
                *held);
        else if (right && held != m_own.contacts.end())
            add(ContactText::tr("The circles are held and keep their velocities"),
                whoIsMoved(*held) + QLatin1Char(' ')
                    + ContactText::tr("A hit changes velocities: look at whether the lines for "
                                      "that run, at what is asked before them, and at whether "
                                      "later lines change the velocities back."),
                *held);
        else if (right)
            add(ContactText::tr("The circles run through each other"), noneOfThrown(), hit);
        else
            add(isPushedAlone(0)   ? ContactText::tr("Circle 1 answers where it meets circle 2")
                : isPushedAlone(1) ? ContactText::tr("Circle 2 answers where it meets circle 1")
                                   : ContactText::tr("The circles act on each other"),
                ContactText::tr("In this step they should still pass through each other."), hit);
        return true;
    }

    /// No velocity changes, as it should be, but places do.
    bool findHeld()
    {
        const auto isHeld = [](const PairHit &h) { return h.isHeld(); };
        const auto at = std::find_if(m_own.contacts.begin(), m_own.contacts.end(), isHeld);
        if (at == m_own.contacts.end()
            || std::any_of(m_right.contacts.begin(), m_right.contacts.end(), isHeld))
            return false;
        add(ContactText::tr("The circles act on each other"),
            ContactText::tr("Where they overlapped, your program put circle %1 elsewhere than its "
                            "velocity takes it. In this step they should still pass through each "
                            "other.")
                .arg(at->moved1 ? 1 : 2),
            *at, Suspect::Answer);
        return true;
    }

    /// Whether that circle, from 0, changes its velocity in hits, and the other in none.
    [[nodiscard]] bool isPushedAlone(int circle) const
    {
        return std::all_of(
            m_own.contacts.begin(), m_own.contacts.end(), [circle](const PairHit &hit) {
                return !hit.answered || length(circle == 0 ? hit.push2() : hit.push1()) < 1e-9;
            });
    }

    static QString whoIsMoved(const PairHit &hit)
    {
        return hit.moved1 && hit.moved2
                   ? ContactText::tr("When they touched neither moved on as its velocity says, and "
                                     "after the step they had the velocities of before.")
                   : ContactText::tr("When they touched circle %1 did not move on as its velocity "
                                     "says, and after the step both had the velocities of before.")
                         .arg(hit.moved1 ? 1 : 2);
    }

    /// That none of those that are thrown is answered.
    [[nodiscard]] QString noneOfThrown() const
    {
        return ContactText::tr("From all %1 directions in which they were thrown at each other, "
                               "with up to %2 m/s along the line of centres, neither of them "
                               "changed its velocity.")
            .arg(QString::number(m_own.contacts.size()), brief(fastestThrown()));
    }

    /// Whether circle 2 rests in all meetings that are thrown.
    [[nodiscard]] bool areAllAtRest() const
    {
        return std::all_of(m_own.contacts.begin(), m_own.contacts.end(), [](const PairHit &hit) {
            const PairVelocities &v = hit.meeting.velocities;
            return v.along2 == 0.0 && v.across2 == 0.0;
        });
    }

    /// That none is answered in which circle 2 rests; \p own, in which it does not, is.
    void addOfMoving(const PairHit &own)
    {
        const auto held = std::find_if(m_own.contacts.begin(), m_own.contacts.end(),
                                       [](const PairHit &h) { return h.isHeldAlone(); });
        const bool isHeld = held != m_own.contacts.end();
        add(isHeld ? ContactText::tr("The circles are held and keep their velocities")
                   : ContactText::tr("No hit tried is answered but that of your own scene"),
            (isHeld ? whoIsMoved(*held) : noneOfThrown()) + QLatin1Char(' ')
                + ContactText::tr("In all %1 meetings tried circle 2 was at rest; in your own "
                                  "scene it came with %2 m/s, and there they were answered in "
                                  "time. Look at whose velocities the answer is made of, and at "
                                  "what is asked before it.")
                      .arg(QString::number(m_own.contacts.size()), brief(own.came2)),
            whereTheyTouch(m_own.contacts.front()));
    }

    /// The first hit of the own scene is answered, and none of those that are thrown.
    void findOwnAlone()
    {
        const PairHit &hit = *m_own.own;
        const QString seen = noneOfThrown() + QLatin1Char(' ');
        if (isInTime(hit) && hit.came2 != Vec2{} && areAllAtRest())
            addOfMoving(hit);
        else if (isInTime(hit))
            add(ContactText::tr("No hit tried is answered but that of your own scene"),
                seen
                    + ContactText::tr("In your own scene, with %1 m/s, they were answered in time: "
                                      "look at what your program asks before they answer.")
                          .arg(brief(hit.slowness * dot(hit.came1 - hit.came2, hit.normal))),
                whereTheyTouch(m_own.contacts.front()));
        else
            add(ContactText::tr("The circles are answered much too late, or not at all"),
                seen
                    + ContactText::tr("In your own scene their velocities changed where their "
                                      "centres were between %1 and %2 m apart; rims touch there at "
                                      "%3 m. Look at what their distance is compared with, and at "
                                      "what is asked besides.")
                          .arg(brief(hit.reached), brief(hit.before), brief(hit.meeting.sum())),
                whereTheyTouch(m_own.contacts.front()));
    }

    /// All that are answered are answered when they leave each other.
    bool findParting()
    {
        if (meetsAny(m_own.contacts) || isAnyInTime(m_own.varied))
            return false;
        const auto found = std::find_if(m_own.contacts.begin(), m_own.contacts.end(),
                                        [](const PairHit &h) { return h.answered; });
        if (found == m_own.contacts.end())
            return false;
        const PairHit &hit = *found;
        const bool isOfStepBefore =
            std::any_of(m_own.partings.begin(), m_own.partings.end(),
                        [](const PairHit &part) { return !part.answered && part.afterRest; });
        if (!isOfStepBefore && !answersAny(m_own.partings) && !hit.isHeld() && hit.reached == 0.0) {
            add(ContactText::tr("The circles answer where their centres meet"),
                ContactText::tr("They ran into each other until their centres were %1 m apart, and "
                                "were answered in the step in which these passed each other; "
                                "circles that overlap and move apart are not answered. Rims touch "
                                "where the centres are r₁ + r₂ apart: look at what their distance "
                                "is compared with.")
                    .arg(brief(hit.before)),
                hit, Suspect::Reach);
            return true;
        }
        const QString seen = hit.isHeld()
                                 ? ContactText::tr("They touched, their places were changed and "
                                                   "their velocities kept, until they moved apart.")
                                 : ContactText::tr("They ran into each other until their centres "
                                                   "were %1 m apart, and were answered when that "
                                                   "grew again.")
                                       .arg(brief(hit.before));
        // Who only answers late may do so while others, that come more slowly, still meet.
        if (!isOfStepBefore && !m_own.partings.empty() && !answersAny(m_own.partings)
            && !hit.isHeld()) {
            add(ContactText::tr("The circles are answered long after they meet"),
                seen + QLatin1Char(' ')
                    + ContactText::tr("Circles that overlap at the start of a run and move apart "
                                      "are not answered at once. Look at what is asked before "
                                      "they answer, and at what your program counts, or keeps "
                                      "from one step to the next."),
                hit, Suspect::Question);
            return true;
        }
        add(ContactText::tr("The circles answer when they part, not when they meet"),
            seen + QLatin1Char(' ')
                + (isOfStepBefore
                       ? ContactText::tr("The distance of circles that come nearer is less than "
                                         "in the step before: look at what your program compares "
                                         "with what it keeps from there.")
                       : ContactText::tr("Circles that come nearer have a positive closing speed "
                                         "(v₁ − v₂)·n, with n from 1 to 2: look at the comparison, "
                                         "and at which way your normal points.")),
            hit);
        return true;
    }
};

} // namespace

std::optional<std::vector<LawDeviation>>
noneAnswered(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground)
{
    return NoneAnswered(own, right, ground).judge();
}

} // namespace cradle
