// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges which meetings are answered.
class MeetingJudge : ContactComparison
{
public:
    using ContactComparison::ContactComparison;

    [[nodiscard]] std::vector<LawDeviation> judge(Meetings which)
    {
        switch (which) {
        case Meetings::Parting:
            findPartings();
            findTwice();
            break;
        case Meetings::Later:
            findOnce();
            break;
        case Meetings::SlowOrFast:
            findSpeed();
            break;
        case Meetings::FastAlone:
            findFastAlone();
            break;
        }
        return std::move(m_found);
    }

private:
    void addUnanswered(const QString &headline, const PairHit &hit)
    {
        const PairVelocities &v = hit.meeting.velocities;
        add(headline,
            ContactText::tr("Along the line of centres circle 1 had %1 m/s and circle 2 %2 m/s, so "
                            "they came nearer with %3 m/s, and ran into each other; other meetings "
                            "are answered. What counts is the velocity of one relative to the "
                            "other.")
                .arg(brief(hit.slowness * v.along1), brief(hit.slowness * v.along2),
                     brief(hit.slowness * hit.meeting.closing())),
            hit);
    }

    /// Of the slow and the fast ones.
    void findSpeed()
    {
        findSpeed(m_own.slow, m_right.slow, notSlowly());
        findSpeed(m_own.fast, m_right.fast,
                  ContactText::tr("Circles that come nearer fast are not answered"));
    }

    void findSpeed(const std::optional<PairHit> &own, const std::optional<PairHit> &right,
                   const QString &headline)
    {
        if (own && right && !own->answered && !own->stopped && right->isMet()
            && answersAny(m_own.equals))
            addSpeed(headline, *own, m_own.contacts.front());
    }

    void findFastAlone()
    {
        if (m_own.fast && m_own.fast->isMet())
            addSpeed(notSlowly(), m_own.contacts.front(), *m_own.fast);
    }

    static QString notSlowly()
    {
        return ContactText::tr("Circles that come nearer slowly are not answered");
    }

    void addSpeed(const QString &headline, const PairHit &missed, const PairHit &answered)
    {
        const auto speed = [](const PairHit &hit) {
            return brief(hit.slowness * hit.meeting.closing());
        };
        add(headline,
            (missed.isHeld()
                 ? ContactText::tr("They came nearer with %1 m/s, touched and kept their "
                                   "velocities; with %2 m/s they are answered.")
                 : ContactText::tr("They came nearer with %1 m/s and ran into each other; with %2 "
                                   "m/s they are answered."))
                    .arg(speed(missed), speed(answered))
                + QLatin1Char(' ')
                + ContactText::tr("How fast they come does not matter: what counts is whether they "
                                  "overlap and come nearer."),
            whereTheyTouch(missed));
    }

    void findOnce()
    {
        if (!m_own.ranThrough || m_right.ownContacts < 2)
            return;
        if (m_own.returning && !m_own.returning->isMet())
            return addUnanswered(
                ContactText::tr("Nothing happens when it is circle 2 that comes nearer"),
                *m_own.returning);
        if (m_own.ranThroughAnew && !m_own.ranThroughAnew->answered) {
            const PairHit &hit = *m_own.ranThroughAnew;
            return add(ContactText::tr("Not every meeting is answered"),
                       ContactText::tr("Near %1 m circle 1 came with %2 m/s and circle 2 with %3 "
                                       "m/s, and they ran into each other; elsewhere others are "
                                       "answered. What counts is whether they overlap and come "
                                       "nearer.")
                           .arg(brief(hit.meeting.middle), brief(hit.came1), brief(hit.came2)),
                       hit);
        }
        if (m_own.ranThroughAtOnce)
            return add(
                ContactText::tr("A hit soon after another is not answered"),
                ContactText::tr(
                    "Circle 2 was hit, was back from the wall close behind it within a "
                    "few steps and ran into circle 1 without an answer; from a wall "
                    "farther off it gets one. What counts is whether they overlap and come nearer, "
                    "not when the last hit was, nor whether a wall is near."),
                m_own.contacts.front());
        add(ContactText::tr("A later hit is not answered"),
            ContactText::tr(
                "Circle 2 was hit, came back from the wall behind it and ran through "
                "circle 1. What counts is whether they overlap and come nearer: look at "
                "what else is asked, and at what your program keeps of a hit."),
            m_own.contacts.front());
        m_found.back().topic = Topic::Memory;
    }

    /// Whether this program itself ever leaves two circles overlapping that move apart.
    [[nodiscard]] bool leavesInside() const
    {
        const auto inside = [](const PairHit &hit) { return hit.answered && hit.partsInside; };
        return std::any_of(m_own.contacts.begin(), m_own.contacts.end(), inside)
               || std::any_of(m_own.rebounds.begin(), m_own.rebounds.end(), inside);
    }

    void findPartings()
    {
        const auto hit = [](const PairHit &h) { return h.answered && h.step == 1; };
        const auto at = std::find_if(m_own.partings.begin(), m_own.partings.end(), hit);
        if (at == m_own.partings.end() || (answersAny(m_own.equals) && !leavesInside())
            || std::any_of(m_right.partings.begin(), m_right.partings.end(), hit))
            return;
        const bool never = !answersAny(m_own.equals);
        // Who remembers a hit answers the first that it sees, and no other; who compares with the
        // step before, the first of a run. A wrong answer may be what parts them at once.
        if (never || (at->afterRest && (at->again || (at->anew && answersRightly()))))
            addParting(never ? ContactText::tr("The circles answer when they part, not when they "
                                               "meet")
                             : ContactText::tr("Circles that already part are hit again"),
                       *at);
    }

    /// As it comes after a hit of the program's own.
    void findTwice()
    {
        if (m_found.empty() && answersRightly() && m_own.twice && !m_right.twice)
            addParting(ContactText::tr("Circles that already part are hit again"), *m_own.twice,
                       m_own.twice->anew ? Asks::Nearing : Asks::Kept);
    }

    /// What decides whether they are hit: what is asked of them, or what is kept of steps before.
    enum class Asks { Nearing, Kept };

    void addParting(const QString &headline, const PairHit &hit, Asks asks = Asks::Nearing)
    {
        // To what rounding makes of a place that was put right.
        const double gap = hit.before - hit.meeting.sum();
        const QString seen =
            gap < 1e-9
                ? ContactText::tr("They overlapped and moved apart with %1 m/s; the next step "
                                  "turned them to %2 and %3 m/s.")
                : ContactText::tr("They moved apart with %1 m/s, with %4 m between their rims; the "
                                  "next step turned them to %2 and %3 m/s.")
                      .replace(QLatin1String("%4"), brief(gap));
        const QString why =
            asks == Asks::Nearing
                ? ContactText::tr("Circles that move apart have had their hit: ask whether they "
                                  "come nearer.")
                : ContactText::tr("A run that begins so leaves them alone: look at what your "
                                  "program keeps from one step to the next.");
        add(headline,
            seen.arg(brief(hit.slowness * dot(hit.came2 - hit.came1, hit.nextNormal)),
                     brief(hit.slowness * hit.left1), brief(hit.slowness * hit.left2))
                + QLatin1Char(' ') + why,
            hit);
        if (asks == Asks::Kept)
            m_found.back().topic = Topic::Memory;
    }
};

} // namespace

std::vector<LawDeviation> meetingDeviations(Meetings which, const MeasuredPair &own,
                                            const MeasuredPair &right, const Ground &ground)
{
    return MeetingJudge(own, right, ground).judge(which);
}

} // namespace cradle
