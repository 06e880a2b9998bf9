// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct DirectionLawText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// World velocities taken apart along the line of centres.
PairVelocities apart(const EqualHit &h, Vec2 v1, Vec2 v2)
{
    const Vec2 n = h.hit.normal;
    const Vec2 t = perpendicular(n);
    return {dot(v1, n), dot(v1, t), dot(v2, n), dot(v2, t)};
}

Vec2 together(const EqualHit &h, double along, double across)
{
    return along * h.hit.normal + across * perpendicular(h.hit.normal);
}

/// Each gets the share of the closing speed along \p n that is right along the line of centres; of
/// two equal circles the parts change hands without losses.
PairVelocities exchangedAlong(const EqualHit &h, Vec2 n)
{
    const double u = dot(h.hit.came1 - h.hit.came2, n);
    const double closing = h.in.along1 - h.in.along2;
    const double share1 = (h.right.along1 - h.in.along1) / closing;
    const double share2 = (h.right.along2 - h.in.along2) / closing;
    return apart(h, h.hit.came1 + share1 * u * n, h.hit.came2 + share2 * u * n);
}

Vec2 rotated(Vec2 v, double angle)
{
    return {std::cos(angle) * v.x - std::sin(angle) * v.y,
            std::sin(angle) * v.x + std::cos(angle) * v.y};
}

double angleOf(const EqualHit &h)
{
    return std::atan2(h.hit.normal.y, h.hit.normal.x);
}

/// What is right, \p factor times as large.
PairVelocities scaled(const EqualHit &h, double factor)
{
    return faster(h.right, factor);
}

/// Of the centres in the middle of the step, m.
double middleDistance(const EqualHit &h)
{
    return 0.5 * (h.hit.before + h.hit.reached);
}

using DirectedHit = const EqualHit &;

} // namespace

std::vector<ResponseLaw> directionLaws()
{
    const QString unit =
        DirectionLawText::tr("A direction has length 1: divide it by its own length, "
                             "else its length comes into the push, and twice.");
    const QString both = DirectionLawText::tr(
        "Along the line of centres and across it alike the velocities are multiplied by one "
        "number. Both directions need length 1, else their length comes in twice.");
    const QString once = DirectionLawText::tr(
        "The push is multiplied by the distance of the centres, in m. A direction has length 1: "
        "divide the way from one to the other by its length wherever it stands.");
    const QString inverse = DirectionLawText::tr(
        "The push is divided by the square of the distance of the centres, in m. A direction has "
        "length 1: look at how often the way from one to the other is divided by its length.");
    const QString again = DirectionLawText::tr(
        "The distance, in m, must not change the size of the push. Look at how often the way from "
        "one to the other is divided by its length.");
    const QString line =
        DirectionLawText::tr("The push acts along the line from centre to centre.");
    return {
        {[](DirectedHit h) { return pushed(h, middleDistance(h) * middleDistance(h)); },
         DirectionLawText::tr("The normal does not have length 1"), unit},
        {[](DirectedHit h) { return scaled(h, middleDistance(h) * middleDistance(h)); },
         DirectionLawText::tr("Normal and tangent are too short"), both},
        {[](DirectedHit h) { return scaled(h, 1.0 / (middleDistance(h) * middleDistance(h))); },
         DirectionLawText::tr("Normal and tangent are too long"), both},
        {[](DirectedHit h) { return pushed(h, 1.0 / (middleDistance(h) * middleDistance(h))); },
         DirectionLawText::tr("The normal does not have length 1"), inverse},
        {[](DirectedHit h) { return pushed(h, middleDistance(h)); },
         DirectionLawText::tr("The distance of the centres comes into the push"), once},
        {[](DirectedHit h) { return pushed(h, 1.0 / middleDistance(h)); },
         DirectionLawText::tr("The push is divided by the distance of the centres"), again},
        {[](DirectedHit h) { return exchangedAlong(h, perpendicular(h.hit.normal)); },
         DirectionLawText::tr("The perpendicular of the line of centres is taken for the normal"),
         line},
        {[](DirectedHit h) {
             return exchangedAlong(h, {h.hit.normal.y, h.hit.normal.x});
         },
         DirectionLawText::tr("The parts x and y of the normal are exchanged"),
         DirectionLawText::tr(
             "Where an angle is used: x is its cosine and y its sine, and `math.atan` "
             "takes y first, then x.")},
        {[](DirectedHit h) {
             return exchangedAlong(h, {h.hit.normal.x, -h.hit.normal.y});
         },
         DirectionLawText::tr("The normal is mirrored: the sign of its y is wrong"), line},
        {[](DirectedHit h) { return exchangedAlong(h, normalized(h.hit.came1)); },
         DirectionLawText::tr("The push acts along the velocity of circle 1"), line},
        {[](DirectedHit h) { return exchangedAlong(h, normalized(h.hit.came2)); },
         DirectionLawText::tr("The push acts along the velocity of circle 2"), line},
        {[](DirectedHit h) {
             return exchangedAlong(h, {1.0, 0.0});
         },
         DirectionLawText::tr("The x parts change hands, not those along the line of centres"),
         line},
        {[](DirectedHit h) {
             return exchangedAlong(h, {0.0, 1.0});
         },
         DirectionLawText::tr("The y parts change hands, not those along the line of centres"),
         line},
        {[](DirectedHit h) {
             const double back = -2.0 * angleOf(h);
             return apart(h, rotated(together(h, h.right.along1, h.right.across1), back),
                          rotated(together(h, h.right.along2, h.right.across2), back));
         },
         DirectionLawText::tr("The new velocities are turned back by the wrong angle"),
         DirectionLawText::tr("Who turns by −φ before must turn by +φ afterwards.")},
        {[](DirectedHit h) {
             const double back = -angleOf(h);
             return apart(h, rotated(together(h, h.right.along1, h.right.across1), back),
                          rotated(together(h, h.right.along2, h.right.across2), back));
         },
         DirectionLawText::tr("The new velocities are not turned back"),
         DirectionLawText::tr(
             "They are still taken apart along the line of centres: put them together "
             "again.")}};
}

} // namespace cradle
