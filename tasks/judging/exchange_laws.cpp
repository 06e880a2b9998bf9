// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct ExchangeText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

using ExchangedHit = const EqualHit &;

} // namespace

std::vector<ResponseLaw> exchangeLaws()
{
    const QString both = ExchangeText::tr("The other one leaves as it should. Look at what is "
                                          "worked out for this one.");
    const QString along = ExchangeText::tr("A smooth circle pushes along the line of centres only; "
                                           "each keeps its own part across.");
    const QString old =
        ExchangeText::tr("Both new velocities come from those *before* the hit: look "
                         "at which lines read a velocity that has been written.");
    const QString either = ExchangeText::tr(
        "Both new velocities come from those *before* the hit: look at what each circle gets, and "
        "whether it is read before or after a velocity is written.");
    const QString added = ExchangeText::tr(
        "A hit gives a new part along the line of centres in place of the old one: look at what "
        "the new part is added to.");
    const auto exchanged = [](ExchangedHit h) {
        return PairVelocities{h.in.along2, h.in.across2, h.in.along1, h.in.across1};
    };
    return {
        {exchanged, ExchangeText::tr("The circles exchange their whole velocities"), along, true},
        {[](ExchangedHit h) {
             const Meeting &m = h.hit.meeting;
             const double heavy =
                 std::pow(m.radius2 / m.radius1, 3) * m.density2 / m.density1; // m₂/m₁
             const double mean = (h.in.across1 + heavy * h.in.across2) / (1.0 + heavy);
             return PairVelocities{h.right.along1, mean + m.restitution * (mean - h.in.across1),
                                   h.right.along2, mean + m.restitution * (mean - h.in.across2)};
         },
         ExchangeText::tr("The whole relative velocity is turned round"),
         ExchangeText::tr("What turns the parts along the line of centres round does the same to "
                          "those across. A smooth circle pushes along the line of centres only; "
                          "each keeps its own part across."),
         true},
        {exchanged, ExchangeText::tr("Two equal circles exchange their whole velocities"), along,
         false, true},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1, h.in.across2, h.in.along2, h.in.across1};
         },
         ExchangeText::tr("The parts across change hands, and those along the normal stay"), along},
        {[](ExchangedHit h) {
             const double speed1 = std::hypot(h.in.along1, h.in.across1);
             const double speed2 = std::hypot(h.in.along2, h.in.across2);
             // Who rests has no direction, and stays.
             const double one = speed1 > 0.0 ? speed2 / speed1 : 0.0;
             const double two = speed2 > 0.0 ? speed1 / speed2 : 0.0;
             return PairVelocities{one * h.in.along1, one * h.in.across1, two * h.in.along2,
                                   two * h.in.across2};
         },
         ExchangeText::tr("Each circle keeps its direction and gets the other's speed"),
         ExchangeText::tr("A velocity has a direction, too: what changes hands is the whole "
                          "part along the line of centres, not its length.")},
        // Of one that always rested nothing is known.
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along2, 0, h.in.along1, h.in.across2};
         },
         ExchangeText::tr("Circle 1 loses its part across the normal"), along},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along2, h.in.across1, h.in.along1, 0};
         },
         ExchangeText::tr("Circle 2 loses its part across the normal"), along},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along2, 0, h.in.along1, 0};
         },
         ExchangeText::tr("The parts across the normal are lost"), along},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along2, h.in.across2, h.in.along2, h.in.across2};
         },
         ExchangeText::tr("Both circles leave with the velocity of circle 2"), either},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.in.along1, h.in.across1};
         },
         ExchangeText::tr("Both circles leave with the velocity of circle 1"), either},
        // Δv is the closing speed, then that with the new velocity of the other, times one factor.
        {[](ExchangedHit h) {
             const double share = (h.right.along2 - h.in.along2) / (h.in.along1 - h.in.along2);
             return PairVelocities{h.right.along1, h.right.across1,
                                   h.in.along2 + share * (h.right.along1 - h.in.along2),
                                   h.in.across2};
         },
         ExchangeText::tr("The velocity of circle 2 is worked out from what circle 1 has become"),
         old, true},
        {[](ExchangedHit h) {
             const double share = (h.in.along1 - h.right.along1) / (h.in.along1 - h.in.along2);
             return PairVelocities{h.in.along1 - share * (h.in.along1 - h.right.along2),
                                   h.in.across1, h.right.along2, h.right.across2};
         },
         ExchangeText::tr("The velocity of circle 1 is worked out from what circle 2 has become"),
         old, true},
        {[](ExchangedHit h) {
             return PairVelocities{h.right.along1, h.right.across1, h.in.along2, h.in.across2};
         },
         ExchangeText::tr("Of two equal circles circle 2 leaves a hit as it came"), both},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.right.along2, h.right.across2};
         },
         ExchangeText::tr("Of two equal circles circle 1 leaves a hit as it came"), both},
        {[](ExchangedHit h) {
             const double n = 0.5 * (h.in.along1 + h.in.along2);
             return PairVelocities{n, h.in.across1, n, h.in.across2};
         },
         ExchangeText::tr("After an elastic hit the circles do not part"),
         ExchangeText::tr("They go on side by side and do not part: each gets only half of the "
                          "change that an elastic hit makes. Look for a factor 2 that is "
                          "missing, or for a half or a mean.")},
        {[](ExchangedHit h) {
             const double n = 0.5 * (h.in.along1 + h.in.along2);
             const double t = 0.5 * (h.in.across1 + h.in.across2);
             return PairVelocities{n, t, n, t};
         },
         ExchangeText::tr("After a hit both circles have the same velocity"), along},
        {[](ExchangedHit h) {
             return PairVelocities{0, h.in.across1, h.in.along1 + h.in.along2, h.in.across2};
         },
         ExchangeText::tr("The part of circle 2 along the normal is forgotten"),
         ExchangeText::tr("Circle 1 gives its part away and gets nothing for it.")},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1 + h.in.along2, h.in.across1, 0, h.in.across2};
         },
         ExchangeText::tr("The part of circle 1 along the normal is forgotten"),
         ExchangeText::tr("Circle 2 gives its part away and gets nothing for it.")},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.in.along1 + h.in.along2,
                                   h.in.across2};
         },
         ExchangeText::tr("Circle 1 keeps the part that it hands over"),
         ExchangeText::tr("What circle 2 gets, circle 1 must lose.")},
        {[](ExchangedHit h) {
             return PairVelocities{2.0 * h.in.along1 - h.right.along1, h.right.across1,
                                   h.right.along2, h.right.across2};
         },
         ExchangeText::tr("The push on circle 1 has the wrong sign"),
         ExchangeText::tr("It gains the part that it should lose."), false, true},
        {[](ExchangedHit h) {
             return PairVelocities{h.right.along1, h.right.across1,
                                   2.0 * h.in.along2 - h.right.along2, h.right.across2};
         },
         ExchangeText::tr("The push on circle 2 has the wrong sign"),
         ExchangeText::tr("It loses the part that it should gain."), false, true},
        {[](ExchangedHit h) {
             return PairVelocities{-h.in.along2, h.in.across1, -h.in.along1, h.in.across2};
         },
         ExchangeText::tr("The parts along the normal change hands and are turned round as well"),
         ExchangeText::tr("The exchange alone is the whole answer.")},
        {[](ExchangedHit h) {
             return PairVelocities{-h.in.along2, -h.in.across2, -h.in.along1, -h.in.across1};
         },
         ExchangeText::tr("The whole velocities change hands and are turned round as well"), along},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1 + h.right.along1, h.right.across1,
                                   h.in.along2 + h.right.along2, h.right.across2};
         },
         ExchangeText::tr("Both circles get their new part along the normal besides the old"),
         added, false, true},
        {[](ExchangedHit h) {
             return PairVelocities{h.in.along1 + h.right.along1, h.right.across1, h.right.along2,
                                   h.right.across2};
         },
         ExchangeText::tr("Circle 1 gets its new part along the normal besides the old"), added,
         false, true},
        {[](ExchangedHit h) {
             return PairVelocities{h.right.along1, h.right.across1, h.in.along2 + h.right.along2,
                                   h.right.across2};
         },
         ExchangeText::tr("Circle 2 gets its new part along the normal besides the old"), added,
         false, true},
        {[](ExchangedHit h) { return pushed(h, -1.0); },
         ExchangeText::tr("Both pushes have the wrong sign"),
         ExchangeText::tr("The circles are drawn into each other.")}};
}

} // namespace cradle
