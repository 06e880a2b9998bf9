// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/contact_faults.h"
#include "tasks/checks/hit_places.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"
#include "tasks/checks/standstill.h"

#include "model/files/preset_json.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <functional>

namespace cradle::kinds {

namespace {

std::vector<CircleLaw> wantedLaws(const CheckSpec &check)
{
    std::vector<CircleLaw> laws;
    for (const QJsonValue &name : valueOf(check, QStringLiteral("laws")).toArray()) {
        if (const auto law = circleLawFromName(name.toString()))
            laws.push_back(*law);
    }
    return laws;
}

/// A hit too early, or of circles that part already.
std::optional<Fault> untimely(const ContactAnswer &answer, double gapAllowed)
{
    const bool isEarly = answer.contact.nearest > gapAllowed;
    const double slack = motion::sameVelocity * (1.0 + quickLength(answer.contact.beforeA));
    if (!isEarly && answer.approach() >= -slack)
        return std::nullopt;
    if (auto fault = motion::steadyFaultOf(answer.o, answer.a, answer.b, answer.gravity()))
        return fault;
    return isEarly ? contact_faults::tooEarly(answer) : contact_faults::hitAgain(answer);
}

std::optional<Fault> notBy(const std::vector<CircleLaw> &laws, const ContactAnswer &answer)
{
    const bool follows =
        std::any_of(laws.begin(), laws.end(), [&](CircleLaw law) { return answer.follows(law); });
    if (follows)
        return std::nullopt;
    // What one circle follows is what is meant.
    const auto isHalfRight = [&](CircleLaw law) {
        const auto [a, b] = answer.expected(law, answer.normal());
        return motion::isSame(answer.contact.afterA, a, answer.tolerance)
               || motion::isSame(answer.contact.afterB, b, answer.tolerance);
    };
    const auto meant = std::find_if(laws.begin(), laws.end(), isHalfRight);
    return contact_faults::wrongAnswer(answer, meant == laws.end() ? laws.front() : *meant);
}

/// Newton's law of restitution: what parts them along the normal is e times what closed the gap.
std::optional<Fault> notByRestitution(const ContactAnswer &answer)
{
    const Vec2 n = answer.normal();
    const double closing = dot(answer.contact.beforeA - answer.contact.beforeB, n);
    const double parting = dot(answer.contact.afterB - answer.contact.afterA, n);
    const bool follows = std::abs(parting - answer.restitution * closing)
                         <= answer.tolerance * (1.0 + std::abs(closing));
    return follows ? std::nullopt
                   : std::optional(contact_faults::wrongRebound(answer, closing, parting));
}

/// What gravity moves circles with different integrators apart in a step, m.
double slackOf(const Observation &o, Vec2 gravity)
{
    const double dt = o.timestep();
    return quickLength(gravity) * dt * dt;
}

/// A circle that the hit puts somewhere else, such as onto the other one. Moving them apart by
/// what they overlap is none.
std::optional<Fault> leapIn(const ContactAnswer &answer, Vec2 gravity)
{
    const qint64 k = answer.contact.step;
    const double way = motion::recentTravel(answer.o, answer.a, k, gravity)
                       + motion::recentTravel(answer.o, answer.b, k, gravity);
    const auto fault = motion::leap(answer.o, answer.a, k, way);
    return fault ? fault : motion::leap(answer.o, answer.b, k, way);
}

/// What circle \p i, one of the two of \p answer, makes of its place in the step of the hit.
HitPlace placeOf(const ContactAnswer &answer, int i)
{
    const motion::Contact &contact = answer.contact;
    const Circle &before = answer.o.circle(i, contact.step);
    const Circle &after = answer.o.circle(i, contact.step + 1);
    const Circle &other = answer.o.circle(i == answer.a ? answer.b : answer.a, contact.step);
    const double dt = answer.o.timestep();
    const Vec2 normal = answer.middleNormal();
    double turn = 0.0;
    for (const Vec2 each :
         {contact.normalFirst, contact.normalLast, contact.normalA, contact.normalB})
        turn = std::max(turn, std::abs(cross(each, normal)) / dot(each, normal));
    return {.apart = i == answer.a ? -1.0 * normal : normal,
            .turn = turn,
            .overlap = std::max(0.0, -contact.nearest),
            .isLate = quickLength(other.position - before.position) < before.radius + other.radius,
            .free = dt * before.velocity,
            .bounced = dt * after.velocity,
            .made = after.position - before.position};
}

/// A circle that the hit puts into the other, aside or far away.
std::optional<Fault> misplacedBy(const ContactAnswer &answer, Vec2 gravity)
{
    for (const int i : {answer.a, answer.b}) {
        const double slack = motion::samePosition + 2.0 * slackOf(answer.o, gravity);
        const auto found = misplacementOf(placeOf(answer, i), slack);
        // Who goes another way in the open, too, is told that by checks of the motion.
        if (found && !motion::steadyFaultOf(answer.o, answer.a, answer.b, gravity))
            return contact_faults::misplaced(answer, i, *found);
    }
    return std::nullopt;
}

/// Whether only the hit that a scene of parting circles begins with was answered. A program that
/// remembers a hit instead of asking for approach cannot know of one before the scene; who asks for
/// nothing answers again as soon as they part again.
bool answersOnlyTheStart(const CheckSpec &check, const Observation &o,
                         const std::vector<motion::Contact> &contacts)
{
    const auto parts = [&](const motion::Contact &contact) {
        const double slack = motion::sameVelocity * (1.0 + quickLength(contact.beforeA));
        return ContactAnswer{o, 0, 1, contact, 1.0, slack}.approach() < -slack;
    };
    return valueOf(check, QStringLiteral("contacts")).toInt() == 0 && !contacts.empty()
           && contacts.front().step == 0
           && std::count_if(contacts.begin(), contacts.end(), parts) == 1
           && parts(contacts.front());
}

/// The same with all velocities turned round: circles that part approach, and an answer to them is
/// right if it is right so, as every law is linear in the velocities.
motion::Contact backwards(motion::Contact contact)
{
    for (Vec2 *velocity : {&contact.beforeA, &contact.beforeB, &contact.afterA, &contact.afterB})
        *velocity = -1.0 * *velocity;
    return contact;
}

/// What is wrong if they had run into each other by \p missedStep: answered late, or never.
Fault missedFault(const Observation &o, qint64 missedStep, double e,
                  const std::vector<motion::Contact> &contacts)
{
    for (qint64 k = missedStep; k < o.steps(); ++k) {
        const Circle &a = o.circle(0, k);
        const Circle &b = o.circle(1, k);
        const double centres = quickLength(b.position - a.position);
        if (centres >= a.radius + b.radius)
            break;
        const bool isAnswered =
            std::any_of(contacts.begin(), contacts.end(),
                        [k](const motion::Contact &contact) { return contact.step == k; });
        if (isAnswered)
            return contact_faults::late(missedStep, k + 1, centres);
    }
    return contact_faults::missed(missedStep, e);
}

using JudgeAnswer = std::function<std::optional<Fault>(const ContactAnswer &)>;

/// Goes through the contacts of circles 1 and 2: each in time, each answered as \p judge wants it,
/// and none missed.
std::optional<Fault> inTurn(const CheckSpec &check, const Observation &o, double gapAllowed,
                            const JudgeAnswer &judge)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    const double e = motion::restitutionOf(check, o);
    const double tolerance = motion::toleranceOf(check);
    const std::vector<motion::Contact> contacts = motion::contactsOf(o, 0, 1, gravity);
    if (answersOnlyTheStart(check, o, contacts)
        && !judge(ContactAnswer{o, 0, 1, backwards(contacts.front()), e, tolerance}))
        return std::nullopt;
    const qint64 missedStep = motion::missedContact(o, 0, 1);
    const int wanted = valueOf(check, QStringLiteral("contacts")).toInt();
    // Who is set into another circle, as nothing of the program's brings it there, may be held.
    const bool isAnyHitWanted = wanted > 0;
    std::optional<Fault> besideWall; // told where nothing in the open is wrong
    std::optional<qint64> lastRight; // the state that such a hit made
    const auto told = [&lastRight](const Fault &fault) {
        return lastRight ? contact_faults::afterRight(fault, *lastRight) : fault;
    };
    for (const motion::Contact &contact : contacts) {
        if (missedStep >= 0 && missedStep < contact.step)
            break;
        const ContactAnswer answer{o, 0, 1, contact, e, tolerance};
        auto fault = untimely(answer, gapAllowed + slackOf(o, gravity));
        if (!fault)
            fault = judge(answer);
        if (!fault)
            fault = leapIn(answer, gravity);
        // A wall may put them elsewhere, too.
        if (!fault && !motion::isBesideWall(o, 0, 1, contact, gravity))
            fault = misplacedBy(answer, gravity);
        for (const int i : {0, 1}) {
            if (!fault && isAnyHitWanted)
                fault = motion::standstillAfter(o, i, contact.step, gravity);
        }
        // One that turned before it touched anything has met no wall either.
        const bool isEarly = contact.nearest > gapAllowed + slackOf(o, gravity);
        if (fault && (isEarly || !motion::isBesideWall(o, 0, 1, contact, gravity)))
            return isEarly ? *fault : told(*fault);
        if (fault && !besideWall)
            besideWall = contact_faults::besideWall(*fault);
        if (!fault)
            lastRight = contact.step + 1;
    }
    if (missedStep >= 0)
        return told(missedFault(o, missedStep, e, contacts));
    if (besideWall)
        return besideWall;
    if (contacts.size() < static_cast<std::size_t>(wanted))
        return contact_faults::tooFew(contacts.size(), wanted);
    return std::nullopt;
}

} // namespace

std::optional<Fault> collides(const CheckSpec &check, const Observation &o)
{
    return inTurn(
        check, o, motion::samePosition,
        [laws = wantedLaws(check)](const ContactAnswer &answer) { return notBy(laws, answer); });
}

std::optional<Fault> rebounds(const CheckSpec &check, const Observation &o)
{
    return inTurn(check, o, motion::samePosition, notByRestitution);
}

std::optional<Fault> touches(const CheckSpec &check, const Observation &o)
{
    return inTurn(check, o, motion::toleranceOf(check),
                  [](const ContactAnswer &) { return std::nullopt; });
}

} // namespace cradle::kinds
