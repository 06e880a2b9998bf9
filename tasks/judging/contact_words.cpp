// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/response_law_words.h"

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
        if (auto none = noneAnswered(m_own, m_right, m_ground))
            return std::move(*none);
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
        // A wrong push may be what moves them.
        if (m_found.size() == before && answersRightly())
            findMisplaced();
        // A wrong direction shows here, too, and a push that goes on when they part; it is the
        // response that is wrong.
        if (!divided.isOfWay() && !isDirectionWrong() && !spreadDeviation(m_own, m_right))
            take(meetingDeviations(Meetings::Parting, m_own, m_right, m_ground));
        for (const Meetings more : {Meetings::Later, Meetings::SlowOrFast}) {
            if (m_found.empty() && answersRightly())
                take(meetingDeviations(more, m_own, m_right, m_ground));
        }
        if (const auto missed = m_found.empty() ? missedInStep(m_own, m_right) : std::nullopt)
            m_found.push_back(*missed);
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
        m_found.back().moment.isPosition = true;
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
        m_found.back().moment.isPosition = true;
    }

    /// A hit puts a circle where neither its velocities nor moving them apart take it.
    void findMisplaced()
    {
        const auto isMisplaced = [](const PairHit &h) { return h.misplaced.has_value(); };
        const auto less = [](const PairHit &a, const PairHit &b) {
            return (a.misplaced ? a.misplaced->by : 0.0) < (b.misplaced ? b.misplaced->by : 0.0);
        };
        const auto at = std::max_element(m_own.contacts.begin(), m_own.contacts.end(), less);
        if (at == m_own.contacts.end() || !at->misplaced
            || std::any_of(m_right.contacts.begin(), m_right.contacts.end(), isMisplaced))
            return;
        m_found.push_back(
            {Aspect::Contact,
             misplacedText(*at).arg(QString::number(at->misplacedCircle + 1), brief(at->reached),
                                    brief(at->meeting.sum()), brief(at->misplaced->by)),
             {at->stage, at->step, {at->misplacedCircle}, true}});
    }

    [[nodiscard]] static QString misplacedText(const PairHit &hit)
    {
        switch (hit.misplaced->where) {
        case Misplacement::Where::Into:
            return ContactText::tr(
                "A hit pushes circle %1 into the other one\n\nIn a step that would have brought "
                "their centres to %2 m from each other the hit put circle %1 %4 m nearer to the "
                "other one than its velocities before and after it take it; rims touch at %3 m. "
                "Each goes back to where it came from, or they are moved apart: look at the sign "
                "of the way that circle %1 is moved, and at whose velocity is in it.");
        case Misplacement::Where::Away:
            return ContactText::tr(
                "A hit puts circle %1 too far away\n\nIn a step that would have brought their "
                "centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 "
                "%4 m farther from the other one than its velocities and twice that overlap "
                "explain. It is enough that they touch: look at how far it is moved.");
        case Misplacement::Where::Aside:
            break;
        }
        return ContactText::tr(
            "A hit moves circle %1 to the side\n\nIn a step that would have brought their centres "
            "to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m to the "
            "side of the ways that its velocities before and after it take it. A hit may move "
            "circles apart along the line of centres only: look at the direction in which it is "
            "moved, and at whose velocity is in it.");
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
