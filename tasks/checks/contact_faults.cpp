// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/contact_faults.h"

#include "tasks/checks/figures.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle::contact_faults {

namespace {

struct ContactText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

} // namespace

Fault tooEarly(const ContactAnswer &answer)
{
    const Observation &o = answer.o;
    const qint64 k = answer.contact.step;
    const Vec2 gravity = answer.gravity();
    // Beside a wall a circle may well be turned, whatever the other does.
    const auto isOdd = [&](int i) {
        return motion::isKicked(o, i, k, gravity, answer.tolerance)
               && !motion::isNearWall(o, i, k, gravity);
    };
    const int who = isOdd(answer.a) ? answer.a : answer.b;
    const double gap = answer.contact.nearest;
    const Vec2 before = o.circle(who, k).velocity;
    const Vec2 after = o.circle(who, k + 1).velocity;
    const Vec2 asked = before + o.timestep() * gravity;
    const Circle &a = o.circle(answer.a, k);
    const Circle &b = o.circle(answer.b, k);
    // After a hit they may well have touched: they are apart again.
    const bool isParting = dot(b.position - a.position, b.velocity - a.velocity) > 0.0;
    const QString text =
        isParting && gravity == Vec2{}
            ? ContactText::tr("At step %1 the velocity of circle %2 changed from %3 to %4 m/s "
                              "although the circles were moving apart, with %5 m between their "
                              "rims")
        : isParting
            ? ContactText::tr("At step %1 the velocity of circle %2 went from %3 to %4 m/s "
                              "although the circles were moving apart, with %5 m between their "
                              "rims; %6 m/s is right")
        : gravity == Vec2{}
            ? ContactText::tr("At step %1 the velocity of circle %2 changed from %3 to %4 m/s "
                              "although it touched neither a wall nor the other circle, from whose "
                              "rim it was still %5 m away")
            : ContactText::tr("At step %1 the velocity of circle %2 went from %3 to %4 m/s "
                              "although it touched neither a wall nor the other circle, from whose "
                              "rim it was still %5 m away; %6 m/s is right");
    const QString said = text.arg(QString::number(k + 1), QString::number(who + 1),
                                  motion::figureBeside(before, after),
                                  motion::figureBeside(after, asked), motion::figure(gap));
    return {.message = gravity == Vec2{} ? said : said.arg(motion::figureBeside(asked, after)),
            .expected = 0.0,
            .observed = gap,
            .unit = QStringLiteral("m"),
            .step = k + 1,
            .circle = who};
}

Fault hitAgain(const ContactAnswer &answer)
{
    const motion::Contact &c = answer.contact;
    const auto isKept = [&](Vec2 before, Vec2 after) {
        return motion::isSame(after, before, answer.tolerance);
    };
    // What changes one alone is no hit of the two.
    if (isKept(c.beforeA, c.afterA) != isKept(c.beforeB, c.afterB)) {
        const bool isA = !isKept(c.beforeA, c.afterA);
        const Vec2 before = isA ? c.beforeA : c.beforeB;
        const Vec2 after = isA ? c.afterA : c.afterB;
        const int who = isA ? answer.a : answer.b;
        return {.message =
                    ContactText::tr("At step %1 the velocity of circle %2 changed from %3 to "
                                    "%4 m/s, while the circles moved apart and the other "
                                    "one kept its own; it should stay as it was")
                        .arg(QString::number(c.step + 1), QString::number(who + 1),
                             motion::figureBeside(before, after),
                             motion::figureBeside(after, before)),
                .step = c.step + 1,
                .circle = who};
    }
    return {.message = ContactText::tr("At step %1 the circles were already moving apart with %2 "
                                       "m/s, and their velocities changed from %3 and %4 to %5 and "
                                       "%6 m/s; circles that move apart should be left alone")
                           .arg(QString::number(c.step + 1), motion::figure(-answer.approach()),
                                motion::figureBeside(c.beforeA, c.afterA),
                                motion::figureBeside(c.beforeB, c.afterB),
                                motion::figureBeside(c.afterA, c.beforeA),
                                motion::figureBeside(c.afterB, c.beforeB)),
            .step = c.step + 1};
}

Fault wrongAnswer(const ContactAnswer &answer, CircleLaw law)
{
    const motion::Contact &contact = answer.contact;
    const Vec2 n = answer.normal();
    const auto [afterA, afterB] = answer.expected(law, n);
    const Vec2 errorA = contact.afterA - afterA;
    const Vec2 errorB = contact.afterB - afterB;
    const bool isA = quickLength(errorA) >= quickLength(errorB);
    const Vec2 error = isA ? errorA : errorB;
    const Vec2 right = isA ? afterA : afterB;
    const Vec2 left = isA ? contact.afterA : contact.afterB;
    const bool x = std::abs(error.x) > std::abs(error.y);
    return {.message = ContactText::tr("At step %1 circle 1 left the hit with %2 m/s and circle 2 "
                                       "with %3 m/s; where their line of centres points along %4, "
                                       "%5 and %6 m/s are right")
                           .arg(QString::number(contact.step + 1),
                                motion::figureBeside(contact.afterA, afterA),
                                motion::figureBeside(contact.afterB, afterB), motion::figure(n),
                                motion::figureBeside(afterA, contact.afterA),
                                motion::figureBeside(afterB, contact.afterB)),
            .expected = x ? right.x : right.y,
            .observed = x ? left.x : left.y,
            .unit = QStringLiteral("m/s"),
            .step = contact.step + 1};
}

Fault wrongRebound(const ContactAnswer &answer, double closing, double parting)
{
    const double right = answer.restitution * closing;
    if (parting < -1e-6) // beyond rounding
        return {.message =
                    ContactText::tr("At step %1 the circles met with %2 m/s along the line of "
                                    "centres, and after the hit they still come nearer, with %3 "
                                    "m/s; they should part with e times as much as they met "
                                    "with: with e = %4, %5 m/s")
                        .arg(QString::number(answer.contact.step + 1), motion::figure(closing),
                             motion::figure(-parting), motion::figure(answer.restitution),
                             motion::figure(right)),
                .expected = right,
                .observed = parting,
                .unit = QStringLiteral("m/s"),
                .step = answer.contact.step + 1};
    return {.message =
                ContactText::tr("At step %1 the circles met with %2 m/s along the line "
                                "of centres and parted with %3 m/s; e times as much, "
                                "with e = %4, is %5 m/s")
                    .arg(QString::number(answer.contact.step + 1), motion::figure(closing),
                         motion::figureBeside(parting, right), motion::figure(answer.restitution),
                         motion::figureBeside(right, parting)),
            .expected = right,
            .observed = parting,
            .unit = QStringLiteral("m/s"),
            .step = answer.contact.step + 1};
}

Fault misplaced(const ContactAnswer &answer, int who, const Misplacement &found)
{
    using Where = Misplacement::Where;
    const QString text =
        found.where == Where::Into
            ? ContactText::tr("At step %1 the hit put circle %2 %3 m nearer to the other one than "
                              "its velocities before and after it take it; a hit may move circles "
                              "apart, not into each other")
        : found.where == Where::Away
            ? ContactText::tr("At step %1 the hit put circle %2 %3 m farther from the other one "
                              "than its velocities and twice what they overlapped explain; it is "
                              "enough that they touch")
            : ContactText::tr("At step %1 the hit put circle %2 %3 m to the side of the ways that "
                              "its velocities before and after it take it; a hit may move circles "
                              "apart along the line of centres only");
    return {.message = text.arg(QString::number(answer.contact.step + 1), QString::number(who + 1),
                                motion::figure(found.by)),
            .expected = 0.0,
            .observed = found.by,
            .unit = QStringLiteral("m"),
            .step = answer.contact.step + 1,
            .circle = who};
}

/// \param e  of the scene
Fault missed(qint64 step, double e)
{
    const QString said =
        e == 1.0 ? ContactText::tr("At step %1 the circles have run into each other and go on as "
                                   "if nothing had happened; they should answer as soon as their "
                                   "distance is r₁ + r₂")
                       .arg(step)
                 : ContactText::tr("At step %1, with e = %2, the circles have run into each other "
                                   "and go on as if nothing had happened; they should answer as "
                                   "soon as their distance is r₁ + r₂")
                       .arg(QString::number(step), motion::figure(e));
    return {.message = said, .step = step};
}

Fault late(qint64 step, qint64 answered, double centres)
{
    return {.message =
                ContactText::tr("By step %1 the circles have run into each other, and they "
                                "are answered only in step %2, which begins with their centres "
                                "%3 m apart; they should answer as soon as their distance is "
                                "r₁ + r₂")
                    .arg(QString::number(step), QString::number(answered), motion::figure(centres)),
            .step = step};
}

Fault afterRight(Fault fault, qint64 step)
{
    fault.message = ContactText::tr("%1. Their hit before, at step %2, came out right")
                        .arg(fault.message, QString::number(step));
    return fault;
}

Fault besideWall(Fault fault)
{
    fault.message = ContactText::tr("%1. A wall is reached in this step, too: judge it when the "
                                    "walls are right")
                        .arg(fault.message);
    return fault;
}

Fault tooFew(std::size_t observed, int wanted)
{
    return {.message = observed == 0
                           ? ContactText::tr(
                               "In this scene no velocity changed in a hit of the circles, so "
                               "there is none to judge")
                           : ContactText::tr("Hits that the circles answered: %1; at least %2 is "
                                             "right")
                                 .arg(observed)
                                 .arg(wanted),
            .expected = wanted,
            .observed = static_cast<double>(observed),
            .step = 0};
}

} // namespace cradle::contact_faults
