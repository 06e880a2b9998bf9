// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tasks/judging/contact_tests.h"
#include "tasks/judging/response_laws.h"

#include <QCoreApplication>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

namespace cradle {

namespace {

/// Judges when the circles of a program meet.
class ContactJudge
{
public:
    ContactJudge(const MeasuredPair &own, const MeasuredPair &right, const Ground &ground)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        if (findNever() || findParting())
            return std::move(m_found);
        if (!findSide())
            findDistance();
        findLeap();
        // A wrong direction shows here, too; it is the response that is wrong.
        if (!m_isModeTold && !isDirectionWrong()) {
            findModes();
            findPartings();
        }
        if (answersRightly())
            findOnce();
        if (m_found.empty() && answersRightly())
            findUnanswered();
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const PairHit &hit,
             Suspect suspect = Suspect::Question)
    {
        m_found.push_back({Aspect::Contact,
                           headline + QStringLiteral("\n\n") + body,
                           {hit.stage, std::max<qint64>(hit.step, 1), {0, 1}, false},
                           suspect});
    }

    [[nodiscard]] static bool answersAny(const std::vector<PairHit> &hits)
    {
        return std::any_of(hits.begin(), hits.end(), [](const PairHit &h) { return h.answered; });
    }

    /// Whether equal circles leave a hit as they should: what comes later is judged by that.
    [[nodiscard]] bool answersRightly() const
    {
        return std::equal(m_own.equals.begin(), m_own.equals.end(), m_right.equals.begin(),
                          m_right.equals.end(), [](const PairHit &a, const PairHit &b) {
                              return a.isMet() == b.isMet()
                                     && (!a.isMet() || isSameAnswer(a.leftParts(), b.leftParts()));
                          });
    }

    /// Whether all pushes act along the line of centres.
    static bool pushesAlongCentres(const std::vector<PairHit> &hits)
    {
        return std::all_of(hits.begin(), hits.end(), [](const PairHit &h) {
            const Vec2 t = perpendicular(h.normal);
            const double all = length(h.push1()) + length(h.push2());
            return !h.isMet()
                   || std::abs(dot(h.push1(), t)) + std::abs(dot(h.push2(), t)) < 0.02 * all;
        });
    }

    [[nodiscard]] bool isDirectionWrong() const
    {
        return !answersRightly() && !pushesAlongCentres(m_own.equals)
               && pushesAlongCentres(m_right.equals);
    }

    /// Whether this program itself ever leaves two circles overlapping that move apart.
    [[nodiscard]] bool leavesInside() const
    {
        const auto inside = [](const PairHit &hit) { return hit.answered && hit.partsInside; };
        return std::any_of(m_own.contacts.begin(), m_own.contacts.end(), inside)
               || std::any_of(m_own.rebounds.begin(), m_own.rebounds.end(), inside);
    }

    bool findNever()
    {
        // With e = 1 a hit may come to nothing that is one with another e.
        const bool own =
            answersAny(m_own.contacts) || (!answersAny(m_own.equals) && answersAny(m_own.rebounds));
        const bool right = answersAny(m_right.contacts);
        if (own == right || m_own.contacts.empty())
            return !own;
        PairHit hit = m_own.contacts.front();
        hit.step = right ? m_right.contacts.front().step : hit.step;
        const auto held = std::find_if(m_own.contacts.begin(), m_own.contacts.end(),
                                       [](const PairHit &h) { return h.held; });
        if (right && held != m_own.contacts.end() && held->leaper >= 0)
            add(ContactText::tr("A hit changes the places of the circles, not their velocities"),
                ContactText::tr("When they touched, circle %1 was put to %2 m, far from where it "
                                "came from, and both kept their velocities. A hit changes "
                                "velocities; each circle stays near its own way.")
                    .arg(held->leaper + 1)
                    .arg(brief(held->landed)),
                *held);
        else if (right && held != m_own.contacts.end())
            add(ContactText::tr("The circles are put back and keep their velocities"),
                ContactText::tr("When they touch a place changes and no velocity, so that the next "
                                "step brings them there again. A hit changes velocities: look at "
                                "whether those lines run, and at what they ask."),
                *held);
        else if (right)
            add(ContactText::tr("The circles run through each other"),
                ContactText::tr("From all %1 directions in which they were thrown at each other, "
                                "neither of them changed its velocity.")
                    .arg(m_own.contacts.size()),
                hit);
        else
            add(ContactText::tr("The circles act on each other"),
                ContactText::tr("In this step they should still pass through each other."), hit);
        return true;
    }

    [[nodiscard]] bool fitsAll(const std::function<double(const PairHit &)> &distance,
                               double margin = 0.0) const
    {
        return std::all_of(m_own.contacts.begin(), m_own.contacts.end(), [&](const PairHit &hit) {
            return !hit.isMet() || hit.fits(distance(hit) + margin);
        });
    }

    /// All that are answered are answered when they leave each other.
    bool findParting()
    {
        if (std::any_of(m_own.contacts.begin(), m_own.contacts.end(),
                        [](const PairHit &h) { return h.isMet(); }))
            return false;
        const auto found = std::find_if(m_own.contacts.begin(), m_own.contacts.end(),
                                        [](const PairHit &h) { return h.answered; });
        if (found == m_own.contacts.end())
            return false;
        const PairHit &hit = *found;
        add(ContactText::tr("The circles answer when they part, not when they meet"),
            ContactText::tr("They ran into each other until their centres were %1 m apart, and "
                            "were answered when that grew again. Circles that come nearer have "
                            "a positive closing speed (v₁ − v₂)·n, with n from 1 to 2: look at "
                            "the comparison, and at which way your normal points.")
                .arg(brief(hit.before)),
            hit);
        return true;
    }

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
        m_isModeTold = true;
    }

    static bool isInTime(const PairHit &h) { return h.isMet() && h.fits(h.meeting.sum()); }

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

    void findDistance()
    {
        const auto sum = [](const PairHit &hit) { return hit.meeting.sum(); };
        if (fitsAll(sum))
            return;
        const PairHit &hit = farthestOff();
        for (const ContactTest &test : contactTests(m_ground.pair.radii)) {
            if (!fitsAll(test.distance))
                continue;
            QString body = test.body;
            body.replace(QLatin1String("%1"), brief(hit.meeting.sum()));
            body.replace(QLatin1String("%2"), brief(test.distance(hit)));
            if (!test.body.contains(QLatin1String("%2")))
                body += QLatin1Char(' ') + seen(hit);
            add(test.headline, body, hit, Suspect::Reach);
            return;
        }
        findOtherDistance(hit);
    }

    /// Unequal circles show best whose radius counts.
    static double shows(const PairHit &h)
    {
        return h.meeting.radius1 == h.meeting.radius2 ? 0.1 : 1.0;
    }

    /// The contact whose answer is farthest from the right place.
    [[nodiscard]] const PairHit &farthestOff() const
    {
        return *std::max_element(
            m_own.contacts.begin(), m_own.contacts.end(), [](const PairHit &a, const PairHit &b) {
                const auto off = [](const PairHit &h) {
                    return h.isMet() && !h.fits(h.meeting.sum())
                               ? std::abs(h.before - h.meeting.sum()) * shows(h)
                               : -1.0;
                };
                return off(a) < off(b);
            });
    }

    static QString seen(const PairHit &hit)
    {
        const double degrees = hit.meeting.degrees;
        return ContactText::tr("With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their "
                               "centres were between %4 and %5 m apart.")
            .arg(brief(hit.meeting.radius1), brief(hit.meeting.radius2), brief(degrees),
                 brief(hit.reached), brief(hit.before));
    }

    void findOtherDistance(const PairHit &hit)
    {
        const auto &all = m_own.contacts;
        // Who answers some in time and pushes in a wrong direction asks for approach along that.
        if (isDirectionWrong() && std::any_of(all.begin(), all.end(), [](const PairHit &h) {
                return h.isMet() && h.fits(h.meeting.sum());
            }))
            return;
        double low = 0.0;
        double high = std::numeric_limits<double>::infinity();
        double late = high; // an answer may be a step late
        for (const PairHit &h : all) {
            low = std::max(low, h.reached);
            high = std::min(high, h.before);
            late = std::min(late, 2.0 * h.before - h.reached);
        }
        high = low <= high ? high : late;
        const bool answersAll =
            std::all_of(all.begin(), all.end(), [](const PairHit &h) { return h.answered; });
        if (m_ground.pair.radii.isVaried() && answersAll && low <= high) {
            add(ContactText::tr("A number stands for r₁ + r₂ in the test of contact"),
                ContactText::tr("Whatever the radii are, they answer at the same distance, "
                                "between %1 and %2 m.")
                        .arg(brief(low), brief(high))
                    + QLatin1Char(' ') + seen(hit),
                hit, Suspect::Reach);
            return;
        }
        const bool early = hit.reached > hit.meeting.sum();
        // What comes right from some sides has the reach right; the distance is not.
        const bool isOfSides = std::any_of(all.begin(), all.end(), [&](const PairHit &h) {
            return h.meeting.radius1 == hit.meeting.radius1
                   && h.meeting.radius2 == hit.meeting.radius2 && isInTime(h);
        });
        add(early ? ContactText::tr("The circles answer before they touch")
                  : ContactText::tr("The circles answer too late"),
            seen(hit) + QLatin1Char(' ')
                + ContactText::tr("Rims touch where the centres are r₁ + r₂ apart, here %1 m.")
                      .arg(brief(hit.meeting.sum())),
            hit, Suspect::Reach);
        if (isOfSides)
            m_found.back().topic = Topic::Distance;
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

    enum class Coming { One, Two, Both };

    static Coming comingOf(const PairHit &hit)
    {
        const PairVelocities &v = hit.meeting.velocities;
        return v.along1 <= 0.0 ? Coming::Two : v.along2 >= 0.0 ? Coming::One : Coming::Both;
    }

    void findModes()
    {
        const PairHit *left = nullptr;
        std::set<Coming> answered;
        std::set<Coming> unanswered;
        for (std::size_t i = 0; i < m_own.equals.size(); ++i) {
            const PairHit &hit = m_own.equals[i];
            if (!m_right.equals[i].answered)
                continue;
            (hit.isMet() ? answered : unanswered).insert(comingOf(hit));
            left = hit.isMet() || left ? left : &hit;
        }
        if (!left || answered.empty())
            return;
        const bool isOne = unanswered == std::set{Coming::One} && !answered.contains(Coming::One);
        const bool isTwo = unanswered == std::set{Coming::Two} && !answered.contains(Coming::Two);
        addUnanswered(
            isTwo   ? ContactText::tr("Nothing happens when it is circle 2 that comes nearer")
            : isOne ? ContactText::tr("Nothing happens when it is circle 1 that comes nearer")
                    : ContactText::tr("Not every meeting is answered"),
            left->answered ? *left : whereTheyTouch(*left));
    }

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

    /// Of those that come from all around, and of slow ones.
    void findUnanswered()
    {
        for (std::size_t i = 0; i < m_own.contacts.size(); ++i) {
            const PairHit &hit = m_own.contacts[i];
            if (hit.answered || hit.held || !m_right.contacts[i].isMet())
                continue;
            add(ContactText::tr("Not every meeting is answered"),
                ContactText::tr("With their line of centres at %1° they came nearer with %2 m/s "
                                "along it and ran into each other; other meetings are answered. "
                                "What counts is whether they overlap, and whether the velocity of "
                                "one relative to the other has a part along that line.")
                    .arg(brief(hit.meeting.degrees), brief(hit.slowness * hit.meeting.closing())),
                withStepOf(hit, m_right.contacts[i]));
            return;
        }
        if (!m_own.slow || !m_right.slow || m_own.slow->answered || m_own.slow->held
            || !m_right.slow->isMet() || !answersAny(m_own.equals))
            return;
        const PairHit &hit = *m_own.slow;
        add(ContactText::tr("Circles that come nearer slowly are not answered"),
            ContactText::tr("They came nearer with %1 m/s and ran into each other; with %2 m/s "
                            "they are answered. How fast they come does not matter: what counts "
                            "is whether they overlap and come nearer.")
                .arg(brief(hit.slowness * hit.meeting.closing()),
                     brief(hit.slowness * m_own.contacts.front().meeting.closing())),
            hit.held ? hit : whereTheyTouch(hit));
    }

    /// The same for one that nothing is compared with.
    static PairHit whereTheyTouch(PairHit hit)
    {
        const Preset &preset = hit.stage.preset;
        const Vec2 d = preset.circles[1].body.position - preset.circles[0].body.position;
        const double angle = hit.meeting.degrees * std::numbers::pi / 180.0;
        const double gap = dot(d, {std::cos(angle), std::sin(angle)}) - hit.meeting.sum();
        hit.step = 1 + static_cast<qint64>(gap / (hit.meeting.closing() * preset.timestep));
        return hit;
    }

    /// \p hit, which no step answered, at about the step in which it should be.
    static PairHit withStepOf(PairHit hit, const PairHit &answered)
    {
        hit.step = answered.step;
        return hit;
    }

    void findOnce()
    {
        if (!m_found.empty() || !m_own.ranThrough || m_right.ownContacts < 2)
            return;
        if (m_own.returning && !m_own.returning->isMet())
            return addUnanswered(
                ContactText::tr("Nothing happens when it is circle 2 that comes nearer"),
                *m_own.returning);
        if (m_own.ranThroughAtOnce)
            return add(
                ContactText::tr("A hit soon after another is not answered"),
                ContactText::tr(
                    "Circle 2 was hit, was back from the wall close behind it within a "
                    "few steps and ran into circle 1 without an answer; from a wall "
                    "farther off it gets one. How long ago the last hit was does not matter: what "
                    "counts is whether they overlap and come nearer."),
                m_own.contacts.front());
        add(ContactText::tr("A later hit is not answered"),
            ContactText::tr("Circle 2 was hit, came back from the wall behind it and ran through "
                            "circle 1. What your program remembers of a hit must be forgotten when "
                            "they have parted."),
            m_own.contacts.front());
    }

    void findPartings()
    {
        const auto hit = [](const PairHit &h) { return h.answered && h.step == 1; };
        const auto at = std::find_if(m_own.partings.begin(), m_own.partings.end(), hit);
        if (at == m_own.partings.end() || (answersAny(m_own.equals) && !leavesInside())
            || std::any_of(m_right.partings.begin(), m_right.partings.end(), hit))
            return;
        const bool never = !answersAny(m_own.equals);
        // Who remembers a hit answers the first that it sees, and no other.
        if (!never && !at->again)
            return;
        add(never ? ContactText::tr("The circles answer when they part, not when they meet")
                  : ContactText::tr("Circles that already part are hit again"),
            ContactText::tr(
                "They overlapped and moved apart with %1 m/s; the next step turned them "
                "to %2 and %3 m/s. Circles that move apart have had their hit: ask "
                "whether they come nearer.")
                .arg(brief(-at->slowness * at->meeting.closing()), brief(at->slowness * at->left1),
                     brief(at->slowness * at->left2)),
            *at);
    }

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    const Ground &m_ground;
    std::vector<LawDeviation> m_found;
    bool m_isModeTold = false; ///< it is said already of whose velocities they are answered
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
