// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include "model/contacts/collision_response.h"
#include "model/files/preset_json.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <functional>

namespace cradle::kinds {

namespace {

struct CollideText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// How far a normal may lie outside the honest range, rad: rounding of two subtractions.
constexpr double sameDirection = 1e-6;

/// One contact with the circles and the laws that may answer it.
struct Answer {
    const Observation &o;
    int a;
    int b;
    const motion::Contact &contact;
    double restitution;
    double tolerance;

    [[nodiscard]] bool follows(CircleLaw law) const;
    [[nodiscard]] std::pair<Vec2, Vec2> expected(CircleLaw law, Vec2 n) const;
    [[nodiscard]] Vec2 usedNormal() const;
    [[nodiscard]] bool isHonest(Vec2 n) const;
    [[nodiscard]] Vec2 middleNormal() const;
    [[nodiscard]] Vec2 normal() const;
    [[nodiscard]] double approach() const;
    [[nodiscard]] Vec2 gravity() const;
};

/// The direction of the push that circle b got: what the program took for the normal.
Vec2 Answer::usedNormal() const
{
    const Vec2 pushB = contact.afterB - contact.beforeB;
    const Vec2 pushA = contact.beforeA - contact.afterA;
    return normalized(lengthSquared(pushB) >= lengthSquared(pushA) ? pushB : pushA);
}

Vec2 Answer::middleNormal() const
{
    return normalized(contact.normalFirst + contact.normalLast);
}

/// The normal that the program took if it is honest, else that of the middle of the step.
Vec2 Answer::normal() const
{
    const Vec2 used = usedNormal();
    return isHonest(used) ? used : middleNormal();
}

double Answer::approach() const
{
    const Vec2 u = contact.beforeA - contact.beforeB;
    return std::max(dot(u, contact.normalFirst), dot(u, contact.normalLast));
}

/// What Contact took from the velocities after it, m/s².
Vec2 Answer::gravity() const
{
    return (o.circle(a, contact.step + 1).velocity - contact.afterA) / o.timestep();
}

/// With discrete steps the normal may be that of any moment between the step before the hit and
/// the step of the hit, also while one of the circles has made its step and the other has not.
bool Answer::isHonest(Vec2 n) const
{
    const auto angle = [](Vec2 p, Vec2 q) { return std::abs(std::atan2(cross(p, q), dot(p, q))); };
    const Vec2 first = contact.normalFirst;
    const Vec2 lasts[] = {contact.normalLast, contact.normalA, contact.normalB};
    return std::any_of(std::begin(lasts), std::end(lasts), [&](Vec2 last) {
        return angle(n, first) + angle(n, last) <= angle(first, last) + 2.0 * sameDirection;
    });
}

/// What the two velocities would be after the contact.
std::pair<Vec2, Vec2> Answer::expected(CircleLaw law, Vec2 n) const
{
    Circle ca = o.circle(a, contact.step);
    Circle cb = o.circle(b, contact.step);
    ca.velocity = contact.beforeA;
    cb.velocity = contact.beforeB;
    respond(law, ca, cb, n, restitution);
    return {ca.velocity, cb.velocity};
}

bool Answer::follows(CircleLaw law) const
{
    // Only the last two laws know a direction.
    const bool directed = law == CircleLaw::SwapNormal || law == CircleLaw::Impulse;
    const Vec2 n = directed ? usedNormal() : middleNormal();
    if (directed && !isHonest(n))
        return false;
    const auto [afterA, afterB] = expected(law, n);
    return motion::isSame(contact.afterA, afterA, tolerance)
           && motion::isSame(contact.afterB, afterB, tolerance);
}

std::vector<CircleLaw> wantedLaws(const CheckSpec &check)
{
    std::vector<CircleLaw> laws;
    for (const QJsonValue &name : valueOf(check, QStringLiteral("laws")).toArray()) {
        if (const auto law = circleLawFromName(name.toString()))
            laws.push_back(*law);
    }
    return laws;
}

/// A change of a velocity in the step of \p answer that is no hit's.
std::optional<Fault> ofEveryStep(const Answer &answer)
{
    const Vec2 gravity = answer.gravity();
    const auto fault = motion::steadyFault(answer.o, answer.a, answer.contact.step, gravity);
    return fault ? fault : motion::steadyFault(answer.o, answer.b, answer.contact.step, gravity);
}

Fault tooEarly(const Answer &answer)
{
    const double gap = answer.contact.nearest;
    const motion::Contact &c = answer.contact;
    const bool keepsA = motion::isSame(c.afterA, c.beforeA, answer.tolerance);
    const QString said =
        keepsA != motion::isSame(c.afterB, c.beforeB, answer.tolerance)
            ? CollideText::tr("At step %1 circle %2 changed its velocity although it touched "
                              "neither a wall nor the other circle: their rims were still %3 m "
                              "apart")
                  .arg(QString::number(c.step + 1),
                       QString::number((keepsA ? answer.b : answer.a) + 1), motion::figure(gap))
            : CollideText::tr("At step %1 both circles changed their velocities although they "
                              "touched neither a wall nor each other: their rims were still %2 m "
                              "apart")
                  .arg(QString::number(c.step + 1), motion::figure(gap));
    return {.message = said,
            .expected = 0.0,
            .observed = gap,
            .unit = QStringLiteral("m"),
            .step = c.step + 1};
}

Fault hitAgain(const Answer &answer)
{
    const motion::Contact &c = answer.contact;
    return {.message = CollideText::tr("At step %1 the circles were already moving apart with %2 "
                                       "m/s, and their velocities changed from %3 and %4 to %5 and "
                                       "%6 m/s; circles that move apart should be left alone")
                           .arg(QString::number(c.step + 1), motion::figure(-answer.approach()),
                                motion::figureBeside(c.beforeA, c.afterA),
                                motion::figureBeside(c.beforeB, c.afterB),
                                motion::figureBeside(c.afterA, c.beforeA),
                                motion::figureBeside(c.afterB, c.beforeB)),
            .step = c.step + 1};
}

Fault wrongAnswer(const Answer &answer, CircleLaw law)
{
    const motion::Contact &contact = answer.contact;
    const Vec2 n = answer.normal();
    const auto [afterA, afterB] = answer.expected(law, n);
    const Vec2 error = contact.afterA - afterA;
    const bool x = std::abs(error.x) > std::abs(error.y);
    return {.message = CollideText::tr("At step %1 circle 1 left the hit with %2 m/s and circle 2 "
                                       "with %3 m/s; along the line of centres %4 it should be %5 "
                                       "and %6 m/s")
                           .arg(QString::number(contact.step + 1),
                                motion::figureBeside(contact.afterA, afterA),
                                motion::figureBeside(contact.afterB, afterB), motion::figure(n),
                                motion::figureBeside(afterA, contact.afterA),
                                motion::figureBeside(afterB, contact.afterB)),
            .expected = x ? afterA.x : afterA.y,
            .observed = x ? contact.afterA.x : contact.afterA.y,
            .unit = QStringLiteral("m/s"),
            .step = contact.step + 1};
}

/// A hit too early, or of circles that part already.
std::optional<Fault> untimely(const Answer &answer, double gapAllowed)
{
    const bool isEarly = answer.contact.nearest > gapAllowed;
    const double slack = motion::sameVelocity * (1.0 + quickLength(answer.contact.beforeA));
    if (!isEarly && answer.approach() >= -slack)
        return std::nullopt;
    if (auto fault = ofEveryStep(answer))
        return fault;
    return isEarly ? tooEarly(answer) : hitAgain(answer);
}

std::optional<Fault> notBy(const std::vector<CircleLaw> &laws, const Answer &answer)
{
    const bool follows =
        std::any_of(laws.begin(), laws.end(), [&](CircleLaw law) { return answer.follows(law); });
    return follows ? std::nullopt : std::optional(wrongAnswer(answer, laws.front()));
}

/// Newton's law of restitution: what parts them along the normal is e times what closed the gap.
std::optional<Fault> wrongRebound(const Answer &answer)
{
    const motion::Contact &contact = answer.contact;
    const Vec2 n = answer.normal();
    const double closing = dot(contact.beforeA - contact.beforeB, n);
    const double parting = dot(contact.afterB - contact.afterA, n);
    const double right = answer.restitution * closing;
    if (std::abs(parting - right) <= answer.tolerance * (1.0 + std::abs(closing)))
        return std::nullopt;
    return Fault{.message = CollideText::tr("At step %1 the circles met with %2 m/s along the line "
                                            "of centres and parted with %3 m/s; e times as much, "
                                            "with e = %4, is %5 m/s")
                                .arg(QString::number(contact.step + 1), motion::figure(closing),
                                     motion::figureBeside(parting, right),
                                     motion::figure(answer.restitution),
                                     motion::figureBeside(right, parting)),
                 .expected = right,
                 .observed = parting,
                 .unit = QStringLiteral("m/s"),
                 .step = contact.step + 1};
}

/// \param e  of the scene
Fault missed(qint64 step, double e)
{
    const QString said =
        e == 1.0 ? CollideText::tr("At step %1 the circles have run into each other and go on as "
                                   "if nothing had happened; they should answer as soon as their "
                                   "distance is r₁ + r₂")
                       .arg(step)
                 : CollideText::tr("At step %1, with e = %2, the circles have run into each other "
                                   "and go on as if nothing had happened; they should answer as "
                                   "soon as their distance is r₁ + r₂")
                       .arg(QString::number(step), motion::figure(e));
    return {.message = said, .step = step};
}

Fault tooFew(std::size_t observed, int wanted)
{
    return {.message = observed == 0
                           ? CollideText::tr(
                               "In this scene no velocity changed in a hit of the circles, so "
                               "there is none to judge")
                           : CollideText::tr("Hits that the circles answered: %1; at least %2 is "
                                             "right")
                                 .arg(observed)
                                 .arg(wanted),
            .expected = wanted,
            .observed = static_cast<double>(observed),
            .step = 0};
}

/// What gravity moves circles with different integrators apart in a step, m.
double slackOf(const Observation &o, Vec2 gravity)
{
    const double dt = o.timestep();
    return quickLength(gravity) * dt * dt;
}

/// A circle that the hit puts somewhere else, such as onto the other one. Moving them apart by
/// what they overlap is none.
std::optional<Fault> leapIn(const Answer &answer, Vec2 gravity)
{
    const qint64 k = answer.contact.step;
    const double way = motion::recentTravel(answer.o, answer.a, k, gravity)
                       + motion::recentTravel(answer.o, answer.b, k, gravity);
    const auto fault = motion::leap(answer.o, answer.a, k, way);
    return fault ? fault : motion::leap(answer.o, answer.b, k, way);
}

/// Whether only the hit that a scene of parting circles begins with was answered. A program that
/// remembers a hit instead of asking for approach cannot know of one before the scene; who asks for
/// nothing answers again as soon as they part again.
bool answersOnlyTheStart(const CheckSpec &check, const Observation &o,
                         const std::vector<motion::Contact> &contacts)
{
    const auto parts = [&](const motion::Contact &contact) {
        const double slack = motion::sameVelocity * (1.0 + quickLength(contact.beforeA));
        return Answer{o, 0, 1, contact, 1.0, slack}.approach() < -slack;
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

using JudgeAnswer = std::function<std::optional<Fault>(const Answer &)>;

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
        && !judge(Answer{o, 0, 1, backwards(contacts.front()), e, tolerance}))
        return std::nullopt;
    const qint64 missedStep = motion::missedContact(o, 0, 1);
    for (const motion::Contact &contact : contacts) {
        if (missedStep >= 0 && missedStep < contact.step)
            return missed(missedStep, e);
        const Answer answer{o, 0, 1, contact, e, tolerance};
        if (auto fault = untimely(answer, gapAllowed + slackOf(o, gravity)))
            return fault;
        if (auto fault = judge(answer))
            return fault;
        if (auto fault = leapIn(answer, gravity))
            return fault;
    }
    if (missedStep >= 0)
        return missed(missedStep, e);
    const int wanted = valueOf(check, QStringLiteral("contacts")).toInt();
    if (contacts.size() < static_cast<std::size_t>(wanted))
        return tooFew(contacts.size(), wanted);
    return std::nullopt;
}

} // namespace

std::optional<Fault> collides(const CheckSpec &check, const Observation &o)
{
    return inTurn(check, o, motion::samePosition,
                  [laws = wantedLaws(check)](const Answer &answer) { return notBy(laws, answer); });
}

std::optional<Fault> rebounds(const CheckSpec &check, const Observation &o)
{
    return inTurn(check, o, motion::samePosition, wrongRebound);
}

std::optional<Fault> touches(const CheckSpec &check, const Observation &o)
{
    return inTurn(check, o, motion::toleranceOf(check),
                  [](const Answer &) { return std::nullopt; });
}

} // namespace cradle::kinds
