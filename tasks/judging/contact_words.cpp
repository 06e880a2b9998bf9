// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tasks/judging/contact_comparison.h"

#include <algorithm>
#include <iterator>

namespace cradle {

namespace {

/// Judges when the circles of a program meet.
class ContactJudge : ContactComparison
{
public:
    using ContactComparison::ContactComparison;

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        if (findOpposite() || findNever() || findParting())
            return std::move(m_found);
        DividedMeetings divided(m_own, m_right, m_ground);
        if (!divided.isOfWay())
            take(distanceDeviations(m_own, m_right, m_ground));
        if (auto missed = divided.said(!m_found.empty()))
            m_found.push_back(std::move(*missed));
        const std::size_t before = m_found.size();
        findLeap();
        if (m_found.size() == before)
            findPutFar();
        if (m_found.size() == before)
            findPutTogether();
        // A wrong direction shows here, too; it is the response that is wrong.
        if (!divided.isOfWay() && !isDirectionWrong())
            take(meetingDeviations(Meetings::Parting, m_own, m_right, m_ground));
        for (const Meetings more : {Meetings::Later, Meetings::SlowOrFast}) {
            if (m_found.empty() && answersRightly())
                take(meetingDeviations(more, m_own, m_right, m_ground));
        }
        if (m_found.empty())
            findOwn();
        return std::move(m_found);
    }

private:
    void take(std::vector<LawDeviation> found)
    {
        m_found.insert(m_found.end(), std::make_move_iterator(found.begin()),
                       std::make_move_iterator(found.end()));
    }

    static bool isAnyInTime(const std::vector<PairHit> &hits)
    {
        return std::any_of(hits.begin(), hits.end(),
                           [](const PairHit &hit) { return hit.isInTime(); });
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

    /// How fast those that are thrown come nearer at most, m/s.
    [[nodiscard]] double fastestThrown() const
    {
        double fastest = 0.0;
        for (const PairHit &thrown : m_own.contacts)
            fastest = std::max(fastest, thrown.slowness * thrown.meeting.closing());
        return fastest;
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
        if (!answersAny(m_own.partings) && !hit.isHeld() && hit.reached == 0.0) {
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
        add(ContactText::tr("The circles answer when they part, not when they meet"),
            (hit.isHeld()
                 ? ContactText::tr("They touched, their places were changed and their "
                                   "velocities kept, until they moved apart.")
                 : ContactText::tr("They ran into each other until their centres were %1 m "
                                   "apart, and were answered when that grew again.")
                       .arg(brief(hit.before)))
                + QLatin1Char(' ')
                + ContactText::tr("Circles that come nearer have a positive closing speed "
                                  "(v₁ − v₂)·n, with n from 1 to 2: look at the comparison, and at "
                                  "which way your normal points."),
            hit);
        return true;
    }

    /// The own scene, where other scenes are answered in time.
    void findOwn()
    {
        if (!m_own.own || !m_right.own || !isInTime(*m_right.own) || !m_own.own->isMet()
            || isInTime(*m_own.own) || isDirectionWrong())
            return;
        const PairHit &hit = *m_own.own;
        // Who glances off another comes nearer ever more slowly: it may be a step late, too.
        if (hit.reached <= hit.meeting.sum()
            && hit.meeting.sum() <= hit.before + 2.0 * (hit.before - hit.reached))
            return;
        const auto &before = m_ground.own.circles;
        const bool isOfSpeed = m_own.fast && m_own.fast->isMet() && !isInTime(*m_own.fast);
        const bool isOfOldRadii = !isOfSpeed && before.size() > 1
                                  && hit.fits(before[0].body.radius + before[1].body.radius);
        add(hit.reached > hit.meeting.sum()
                ? ContactText::tr("In your own scene the circles answer before they touch")
                : ContactText::tr("In your own scene the circles answer too late"),
            ContactText::tr("With r₁ = %1 m and r₂ = %2 m they answered when their centres were "
                            "between %3 and %4 m apart; rims touch where that is %5 m.")
                    .arg(brief(hit.meeting.radius1), brief(hit.meeting.radius2), brief(hit.reached),
                         brief(hit.before), brief(hit.meeting.sum()))
                + QLatin1Char(' ')
                + (isOfOldRadii
                       ? ContactText::tr("In scenes that have their radii before your program "
                                         "begins they answer in time.")
                       : ContactText::tr("Thrown with up to %1 m/s along the line of centres they "
                                         "answer in time.")
                             .arg(brief(fastestThrown())))
                + QLatin1Char(' ')
                + (isOfOldRadii
                       ? ContactText::tr("Look at when your program reads the radii: what is read "
                                         "before `on_load` sets them is an old value.")
                       : ContactText::tr("Look at what the distance is compared with, and at what "
                                         "is asked besides.")),
            hit, isOfOldRadii ? Suspect::Copy : Suspect::Question);
    }

    /// Overlapping circles are put as far apart as their rims touch.
    void findPutFar()
    {
        const auto isFar = [](const PairHit &h) { return h.isPutFar(); };
        const auto at = std::find_if(m_own.contacts.begin(), m_own.contacts.end(), isFar);
        if (at == m_own.contacts.end()
            || std::any_of(m_right.contacts.begin(), m_right.contacts.end(), isFar))
            return;
        add(ContactText::tr("A hit puts the circles too far apart"),
            ContactText::tr("They came until their centres were %1 m apart, and the step with the "
                            "answer put them %2 m apart; rims touch at %3 m. It is enough that "
                            "they touch: look at how far each of the two is moved.")
                .arg(brief(at->reached), brief(at->after), brief(at->meeting.sum())),
            *at, Suspect::Answer);
    }

    void findPutTogether()
    {
        const auto isTogether = [](const PairHit &h) { return h.isPutTogether(); };
        const auto at = std::find_if(m_own.contacts.begin(), m_own.contacts.end(), isTogether);
        if (at == m_own.contacts.end()
            || std::any_of(m_right.contacts.begin(), m_right.contacts.end(), isTogether))
            return;
        add(ContactText::tr("A hit puts the circles into each other"),
            ContactText::tr("They came until their centres were %1 m apart, and the step with the "
                            "answer put them %2 m apart; rims touch at %3 m. Look at the place "
                            "that each of the two gets.")
                .arg(brief(at->reached), brief(at->after), brief(at->meeting.sum())),
            *at, Suspect::Answer);
    }

    /// A hit puts each circle near its own path, not at the place of the other.
    void findLeap()
    {
        const auto leaps = [](const PairHit &h) { return h.answered && h.leaper >= 0; };
        const auto at = std::find_if(m_own.contacts.begin(), m_own.contacts.end(), leaps);
        if (at == m_own.contacts.end()
            || std::any_of(m_right.contacts.begin(), m_right.contacts.end(), leaps))
            return;
        m_found.push_back(
            {Aspect::Contact,
             ContactText::tr("A hit puts circle %1 somewhere else\n\nWhen they touched it was put "
                             "to %2 m, far from where it came from. Each circle goes back to its "
                             "*own* old place: look at which one it gets.")
                 .arg(at->leaper + 1)
                 .arg(brief(at->landed)),
             {at->stage, at->step, {at->leaper}, true}});
    }
};

} // namespace

std::vector<LawDeviation> contactDeviations(const MeasuredPair &own, const MeasuredPair &right,
                                            const Ground &ground)
{
    if (!own.isJudged || !right.isJudged)
        return {};
    return ContactJudge(own, right, ground).judge();
}

} // namespace cradle
