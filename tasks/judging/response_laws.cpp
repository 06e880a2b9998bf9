// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"

#include "tasks/judging/likeness.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct ResponseLawText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

constexpr double hitBlur = 5e-3; ///< of a velocity: the line of centres turns a little in a step

using Hit = const EqualHit &;

/// Each circle by itself, or none of them.
std::vector<ResponseLaw> separateLaws()
{
    const QString both = ResponseLawText::tr("A hit acts on both circles.");
    const QString wall =
        ResponseLawText::tr("Nobody holds the other circle as a wall is held: look at "
                            "what each circle gets of the other.");
    return {
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("A hit leaves circle 2 as it was"), both, true},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("A hit leaves circle 1 as it was"), both, true},
        {[](Hit) { return PairVelocities{}; }, ResponseLawText::tr("A hit stops both circles"),
         ResponseLawText::tr("That was right in the step that only looked for the contact.")},
        {[](Hit h) {
             return PairVelocities{0, 0, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("A hit stops circle 1 and leaves circle 2 as it was"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, 0, 0};
         },
         ResponseLawText::tr("A hit stops circle 2 and leaves circle 1 as it was"), both},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, -h.in.across1, -h.in.along2, -h.in.across2};
         },
         ResponseLawText::tr("Each circle is turned back on its own way"), wall},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, h.in.across1, -h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Each circle bounces as off a wall"), wall},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, h.in.across1, h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("Circle 1 bounces as off a wall"), wall},
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1, -h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Circle 2 bounces as off a wall"), wall},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, h.in.across1, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Circle 1 bounces as off a wall, and circle 2 stays as it was"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, -h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Circle 2 bounces as off a wall, and circle 1 stays as it was"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, -h.in.across1, h.in.along2, -h.in.across2};
         },
         ResponseLawText::tr("The parts across the line of centres turn round, not those along it"),
         ResponseLawText::tr("The push acts along the line of centres.")}};
}

/// What changes hands.
std::vector<ResponseLaw> exchangeLaws()
{
    const QString both = ResponseLawText::tr("The other one leaves as it should. Look at what is "
                                             "worked out for this one.");
    const QString along =
        ResponseLawText::tr("A smooth circle pushes along the line of centres only; "
                            "each keeps its own part across.");
    const QString old =
        ResponseLawText::tr("Both new velocities come from those *before* the hit: look "
                            "at which lines read a velocity that has been written.");
    const QString either = ResponseLawText::tr(
        "Both new velocities come from those *before* the hit: look at what each circle gets, and "
        "whether it is read before or after a velocity is written.");
    const QString added = ResponseLawText::tr(
        "A hit gives a new part along the line of centres in place of the old one: look at what "
        "the new part is added to.");
    const auto exchanged = [](Hit h) {
        return PairVelocities{h.in.along2, h.in.across2, h.in.along1, h.in.across1};
    };
    return {
        {exchanged, ResponseLawText::tr("The circles exchange their whole velocities"), along,
         true},
        {[](Hit h) {
             const Meeting &m = h.hit.meeting;
             const double heavy =
                 std::pow(m.radius2 / m.radius1, 3) * m.density2 / m.density1; // m₂/m₁
             const double mean = (h.in.across1 + heavy * h.in.across2) / (1.0 + heavy);
             return PairVelocities{h.right.along1, mean + m.restitution * (mean - h.in.across1),
                                   h.right.along2, mean + m.restitution * (mean - h.in.across2)};
         },
         ResponseLawText::tr("The whole relative velocity is turned round"),
         ResponseLawText::tr(
             "What turns the parts along the line of centres round does the same to "
             "those across. A smooth circle pushes along the line of centres only; "
             "each keeps its own part across."),
         true},
        {exchanged, ResponseLawText::tr("Two equal circles exchange their whole velocities"), along,
         false, true},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across2, h.in.along2, h.in.across1};
         },
         ResponseLawText::tr("The parts across change hands, and those along the normal stay"),
         along},
        {[](Hit h) {
             const double speed1 = std::hypot(h.in.along1, h.in.across1);
             const double speed2 = std::hypot(h.in.along2, h.in.across2);
             // Who rests has no direction, and stays.
             const double one = speed1 > 0.0 ? speed2 / speed1 : 0.0;
             const double two = speed2 > 0.0 ? speed1 / speed2 : 0.0;
             return PairVelocities{one * h.in.along1, one * h.in.across1, two * h.in.along2,
                                   two * h.in.across2};
         },
         ResponseLawText::tr("Each circle keeps its direction and gets the other's speed"),
         ResponseLawText::tr("A velocity has a direction, too: what changes hands is the whole "
                             "part along the line of centres, not its length.")},
        // Of one that always rested nothing is known.
        {[](Hit h) {
             return PairVelocities{h.in.along2, 0, h.in.along1, h.in.across2};
         },
         ResponseLawText::tr("Circle 1 loses its part across the normal"), along},
        {[](Hit h) {
             return PairVelocities{h.in.along2, h.in.across1, h.in.along1, 0};
         },
         ResponseLawText::tr("Circle 2 loses its part across the normal"), along},
        {[](Hit h) {
             return PairVelocities{h.in.along2, 0, h.in.along1, 0};
         },
         ResponseLawText::tr("The parts across the normal are lost"), along},
        {[](Hit h) {
             return PairVelocities{h.in.along2, h.in.across2, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Both circles leave with the velocity of circle 2"), either},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.in.along1, h.in.across1};
         },
         ResponseLawText::tr("Both circles leave with the velocity of circle 1"), either},
        // Δv is the closing speed, then that with the new velocity of the other, times one factor.
        {[](Hit h) {
             const double share = (h.right.along2 - h.in.along2) / (h.in.along1 - h.in.along2);
             return PairVelocities{h.right.along1, h.right.across1,
                                   h.in.along2 + share * (h.right.along1 - h.in.along2),
                                   h.in.across2};
         },
         ResponseLawText::tr(
             "The velocity of circle 2 is worked out from what circle 1 has become"),
         old, true},
        {[](Hit h) {
             const double share = (h.in.along1 - h.right.along1) / (h.in.along1 - h.in.along2);
             return PairVelocities{h.in.along1 - share * (h.in.along1 - h.right.along2),
                                   h.in.across1, h.right.along2, h.right.across2};
         },
         ResponseLawText::tr(
             "The velocity of circle 1 is worked out from what circle 2 has become"),
         old, true},
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Of two equal circles circle 2 leaves a hit as it came"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("Of two equal circles circle 1 leaves a hit as it came"), both},
        {[](Hit h) {
             const double n = 0.5 * (h.in.along1 + h.in.along2);
             return PairVelocities{n, h.in.across1, n, h.in.across2};
         },
         ResponseLawText::tr("After an elastic hit the circles do not part"),
         ResponseLawText::tr("They go on side by side and do not part: each gets only half of the "
                             "change that an elastic hit makes. Look for a factor 2 that is "
                             "missing, or for a half or a mean.")},
        {[](Hit h) {
             const double n = 0.5 * (h.in.along1 + h.in.along2);
             const double t = 0.5 * (h.in.across1 + h.in.across2);
             return PairVelocities{n, t, n, t};
         },
         ResponseLawText::tr("After a hit both circles have the same velocity"), along},
        {[](Hit h) {
             return PairVelocities{0, h.in.across1, h.in.along1 + h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("The part of circle 2 along the normal is forgotten"),
         ResponseLawText::tr("Circle 1 gives its part away and gets nothing for it.")},
        {[](Hit h) {
             return PairVelocities{h.in.along1 + h.in.along2, h.in.across1, 0, h.in.across2};
         },
         ResponseLawText::tr("The part of circle 1 along the normal is forgotten"),
         ResponseLawText::tr("Circle 2 gives its part away and gets nothing for it.")},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.in.along1 + h.in.along2,
                                   h.in.across2};
         },
         ResponseLawText::tr("Circle 1 keeps the part that it hands over"),
         ResponseLawText::tr("What circle 2 gets, circle 1 must lose.")},
        {[](Hit h) {
             return PairVelocities{2.0 * h.in.along1 - h.right.along1, h.right.across1,
                                   h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("The push on circle 1 has the wrong sign"),
         ResponseLawText::tr("It gains the part that it should lose."), false, true},
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1,
                                   2.0 * h.in.along2 - h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("The push on circle 2 has the wrong sign"),
         ResponseLawText::tr("It loses the part that it should gain."), false, true},
        {[](Hit h) {
             return PairVelocities{-h.in.along2, h.in.across1, -h.in.along1, h.in.across2};
         },
         ResponseLawText::tr(
             "The parts along the normal change hands and are turned round as well"),
         ResponseLawText::tr("The exchange alone is the whole answer.")},
        {[](Hit h) {
             return PairVelocities{-h.in.along2, -h.in.across2, -h.in.along1, -h.in.across1};
         },
         ResponseLawText::tr("The whole velocities change hands and are turned round as well"),
         along},
        {[](Hit h) {
             return PairVelocities{h.in.along1 + h.right.along1, h.right.across1,
                                   h.in.along2 + h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("Both circles get their new part along the normal besides the old"),
         added, false, true},
        {[](Hit h) {
             return PairVelocities{h.in.along1 + h.right.along1, h.right.across1, h.right.along2,
                                   h.right.across2};
         },
         ResponseLawText::tr("Circle 1 gets its new part along the normal besides the old"), added,
         false, true},
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1, h.in.along2 + h.right.along2,
                                   h.right.across2};
         },
         ResponseLawText::tr("Circle 2 gets its new part along the normal besides the old"), added,
         false, true},
        {[](Hit h) { return pushed(h, -1.0); },
         ResponseLawText::tr("Both pushes have the wrong sign"),
         ResponseLawText::tr("The circles are drawn into each other.")}};
}

} // namespace

PairVelocities pushed(const EqualHit &h, double factor)
{
    const PairVelocities &in = h.in;
    const PairVelocities &r = h.right;
    return {in.along1 + factor * (r.along1 - in.along1),
            in.across1 + factor * (r.across1 - in.across1),
            in.along2 + factor * (r.along2 - in.along2),
            in.across2 + factor * (r.across2 - in.across2)};
}

bool isSameAnswer(const PairVelocities &a, const PairVelocities &b, double gain)
{
    // A line of centres that has turned a little turns a push that is much too strong.
    const double across = hitBlur + 1e-3 * gain;
    return isAlike(a.along1, b.along1, hitBlur) && isAlike(a.across1, b.across1, across)
           && isAlike(a.along2, b.along2, hitBlur) && isAlike(a.across2, b.across2, across);
}

bool follows(const ResponseLaw &law, const std::vector<EqualHit> &hits)
{
    return !hits.empty() && std::all_of(hits.begin(), hits.end(), [&](const EqualHit &h) {
        const double came = std::max(length(h.hit.came1), length(h.hit.came2));
        const double left = std::max(length(h.hit.left1), length(h.hit.left2));
        return isSameAnswer(h.hit.leftParts(), law.answer(h), std::max(left - came, 0.0));
    });
}

std::vector<EqualHit> comparableHits(const std::vector<PairHit> &own,
                                     const std::vector<PairHit> &right)
{
    std::vector<EqualHit> hits;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].isMet() && right[i].isMet() && own[i].isAligned() && right[i].isAligned())
            hits.push_back({own[i], own[i].cameParts(), right[i].leftParts()});
    }
    return hits;
}

std::vector<ResponseLaw> knownResponses()
{
    std::vector<ResponseLaw> all = separateLaws();
    for (const auto &more : {exchangeLaws(), directionLaws()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace cradle
