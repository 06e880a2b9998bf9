// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/draws.h"

#include "tasks/judging/measured_pair.h"

/// Measured hits that answer by other laws, and of which numbers are changed.
namespace cradle::approved {

inline double massOf(double radius, double density, double power = 3.0)
{
    return density * std::pow(radius, power);
}

/// Pushes of so much momentum along a line, by these masses.
inline void push(PairHit &hit, Vec2 along, double momentum, double mass1, double mass2)
{
    hit.left1 = hit.came1 - momentum / mass1 * along;
    hit.left2 = hit.came2 + momentum / mass2 * along;
}

/// The answer by conserved momentum along a line, with that share of the closing speed coming back.
inline void answer(PairHit &hit, Vec2 along, double e, double mass1, double mass2)
{
    const double closing = dot(hit.came1 - hit.came2, along);
    push(hit, along, (1.0 + e) * closing * mass1 * mass2 / (mass1 + mass2), mass1, mass2);
}

inline void answer(PairHit &hit, Vec2 along, double e)
{
    const Meeting &m = hit.meeting;
    answer(hit, along, e, massOf(m.radius1, m.density1), massOf(m.radius2, m.density2));
}

/// Answered by the step that brings the centres so near; what it makes is left as it is.
inline void meetAt(PairHit &hit, double distance)
{
    const double way = std::abs(hit.before - hit.reached);
    hit.before = distance + 0.4 * way;
    hit.reached = distance - 0.6 * way;
}

struct HitLaw {
    const char *name;
    void (*answer)(PairHit &);
};

inline constexpr HitLaw hitLaws[] = {
    {"right", [](PairHit &) {}},
    {"not at all",
     [](PairHit &h) {
         h.answered = false;
         h.left1 = h.came1, h.left2 = h.came2;
     }},
    {"circle 1 alone", [](PairHit &h) { h.left2 = h.came2; }},
    {"circle 2 alone", [](PairHit &h) { h.left1 = h.came1; }},
    {"velocities exchanged", [](PairHit &h) { h.left1 = h.came2, h.left2 = h.came1; }},
    {"both turned round", [](PairHit &h) { h.left1 = -h.came1, h.left2 = -h.came2; }},
    {"both stop", [](PairHit &h) { h.left1 = h.left2 = {}; }},
    {"without e", [](PairHit &h) { answer(h, h.normal, 1.0); }},
    {"without rebound", [](PairHit &h) { answer(h, h.normal, 0.0); }},
    {"e squared", [](PairHit &h) { answer(h, h.normal, std::pow(h.meeting.restitution, 2)); }},
    {"root of e", [](PairHit &h) { answer(h, h.normal, std::sqrt(h.meeting.restitution)); }},
    {"what e takes", [](PairHit &h) { answer(h, h.normal, 1.0 - h.meeting.restitution); }},
    {"e of a number", [](PairHit &h) { answer(h, h.normal, 0.8); }},
    {"e beside 2", [](PairHit &h) { answer(h, h.normal, 2.0 * h.meeting.restitution - 1.0); }},
    {"equal masses", [](PairHit &h) { answer(h, h.normal, h.meeting.restitution, 1.0, 1.0); }},
    {"masses of discs",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, massOf(m.radius1, m.density1, 2.0),
                massOf(m.radius2, m.density2, 2.0));
     }},
    {"masses without density",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, massOf(m.radius1, 1.0), massOf(m.radius2, 1.0));
     }},
    {"masses without radius",
     [](PairHit &h) {
         answer(h, h.normal, h.meeting.restitution, h.meeting.density1, h.meeting.density2);
     }},
    {"masses exchanged",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, massOf(m.radius2, m.density2),
                massOf(m.radius1, m.density1));
     }},
    {"numbers for masses",
     [](PairHit &h) { answer(h, h.normal, h.meeting.restitution, 1.0, 2.0); }},
    {"mass of one for both",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         const double mass = massOf(m.radius1, m.density1);
         const double closing = dot(h.came1 - h.came2, h.normal);
         push(h, h.normal, (1.0 + m.restitution) * closing * mass / 2.0, mass,
              massOf(m.radius2, m.density2));
     }},
    {"mass forgotten in the sum",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         const double mass1 = massOf(m.radius1, m.density1), mass2 = massOf(m.radius2, m.density2);
         const double closing = dot(h.came1 - h.came2, h.normal);
         push(h, h.normal, (1.0 + m.restitution) * closing * mass1, mass1, mass2);
     }},
    {"along x",
     [](PairHit &h) {
         answer(h, {1.0, 0.0}, h.meeting.restitution);
     }},
    {"along y",
     [](PairHit &h) {
         answer(h, {0.0, 1.0}, h.meeting.restitution);
     }},
    {"across", [](PairHit &h) { answer(h, perpendicular(h.normal), h.meeting.restitution); }},
    {"along the closing velocity",
     [](PairHit &h) { answer(h, normalized(h.came1 - h.came2), h.meeting.restitution); }},
    {"along the line after", [](PairHit &h) { answer(h, h.nextNormal, h.meeting.restitution); }},
    {"mirrored line",
     [](PairHit &h) {
         answer(h, {h.normal.x, -h.normal.y}, h.meeting.restitution);
     }},
    {"line of exchanged parts",
     [](PairHit &h) {
         answer(h, {h.normal.y, h.normal.x}, h.meeting.restitution);
     }},
    {"way for line",
     [](PairHit &h) { answer(h, h.meeting.sum() * h.normal, h.meeting.restitution); }},
    {"wrong sign",
     [](PairHit &h) { h.left1 = h.came1 - h.push1(), h.left2 = h.came2 - h.push2(); }},
    {"wrong sign of circle 2", [](PairHit &h) { h.left2 = h.came2 - h.push2(); }},
    {"push twice",
     [](PairHit &h) { h.left1 = h.came1 + 2.0 * h.push1(), h.left2 = h.came2 + 2.0 * h.push2(); }},
    {"half of the push",
     [](PairHit &h) { h.left1 = h.came1 + 0.5 * h.push1(), h.left2 = h.came2 + 0.5 * h.push2(); }},
    {"part along alone",
     [](PairHit &h) {
         h.left1 = dot(h.left1, h.normal) * h.normal, h.left2 = dot(h.left2, h.normal) * h.normal;
     }},
    {"part along is lost",
     [](PairHit &h) {
         h.left1 = h.left1 - dot(h.left1, h.normal) * h.normal;
         h.left2 = h.left2 - dot(h.left2, h.normal) * h.normal;
     }},
    {"parts across exchanged",
     [](PairHit &h) {
         const Vec2 across = perpendicular(h.normal);
         const Vec2 one = dot(h.left1, across) * across, two = dot(h.left2, across) * across;
         h.left1 = h.left1 - one + two, h.left2 = h.left2 - two + one;
     }},
    {"parts across turned",
     [](PairHit &h) {
         const Vec2 across = perpendicular(h.normal);
         h.left1 = h.left1 - 2.0 * dot(h.left1, across) * across;
         h.left2 = h.left2 - 2.0 * dot(h.left2, across) * across;
     }},
    {"e on all parts",
     [](PairHit &h) {
         answer(h, h.normal, 1.0);
         h.left1 = h.meeting.restitution * h.left1, h.left2 = h.meeting.restitution * h.left2;
     }},
    {"constant push", [](PairHit &h) { push(h, h.normal, 1.0, 1.0, 1.0); }},
    {"constant velocities",
     [](PairHit &h) { h.left1 = -1.0 * h.normal, h.left2 = 1.0 * h.normal; }},
    {"circle 1 rests", [](PairHit &h) { h.left1 = {}, h.left2 = h.came1 + h.came2; }},
    {"velocity of circle 1 for the closing one",
     [](PairHit &h) {
         const double speed = dot(h.came1, h.normal);
         push(h, h.normal, speed, 1.0, 1.0);
     }},
    {"sum for the difference",
     [](PairHit &h) { push(h, h.normal, dot(h.came1 + h.came2, h.normal), 1.0, 1.0); }},
    {"by the size of the closing speed",
     [](PairHit &h) { push(h, h.normal, std::abs(dot(h.came1 - h.came2, h.normal)), 1.0, 1.0); }},
    {"rounded",
     [](PairHit &h) {
         h.left1 = {std::round(h.left1.x), std::round(h.left1.y)};
         h.left2 = {std::round(h.left2.x), std::round(h.left2.y)};
     }},
    {"masses of other powers",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, std::sqrt(m.density1) * std::pow(m.radius1, 4.0),
                std::sqrt(m.density2) * std::pow(m.radius2, 4.0));
     }},
    {"masses of odd powers",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, std::pow(m.density1, 0.7) * std::pow(m.radius1, 2.3),
                std::pow(m.density2, 0.7) * std::pow(m.radius2, 2.3));
     }},
    {"radius of the other",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, massOf(m.radius2, m.density1),
                massOf(m.radius1, m.density2));
     }},
    {"density of the other",
     [](PairHit &h) {
         const Meeting &m = h.meeting;
         answer(h, h.normal, m.restitution, massOf(m.radius1, m.density2),
                massOf(m.radius2, m.density1));
     }},
    {"e for 1 + e", [](PairHit &h) { answer(h, h.normal, h.meeting.restitution - 1.0); }},
    {"1 + 2 e", [](PairHit &h) { answer(h, h.normal, 2.0 * h.meeting.restitution); }},
    {"root of the radius",
     [](PairHit &h) { answer(h, std::sqrt(h.meeting.radius1) * h.normal, 1.0); }},
    {"by the distance", [](PairHit &h) { answer(h, (1.0 / h.reached) * h.normal, 1.0); }},
    {"velocity of circle 1 for both", [](PairHit &h) { h.left1 = h.left2 = h.came1; }},
    {"one velocity for both", [](PairHit &h) { h.left1 = h.left2 = 0.5 * (h.came1 + h.came2); }},
    {"off walls",
     [](PairHit &h) {
         h.left1 = {-h.came1.x, h.came1.y}, h.left2 = {-h.came2.x, h.came2.y};
     }},
    {"from what circle 1 has become",
     [](PairHit &h) {
         const Vec2 came = h.came1;
         h.came1 = h.left1;
         const Vec2 first = h.left1;
         answer(h, h.normal, h.meeting.restitution);
         h.left1 = first, h.came1 = came;
     }},
    {"velocity of circle 1 first", [](PairHit &h) { h.left1 = h.came2, h.left2 = h.left1; }},
    {"radius of circle 1 twice", [](PairHit &h) { meetAt(h, 2.0 * h.meeting.radius1); }},
    {"radius of circle 2 alone", [](PairHit &h) { meetAt(h, h.meeting.radius2); }},
    {"at a number", [](PairHit &h) { meetAt(h, 0.5); }},
    {"too early", [](PairHit &h) { meetAt(h, h.meeting.sum() + 0.1); }},
    {"too late", [](PairHit &h) { meetAt(h, 0.8 * h.meeting.sum()); }},
    {"squares",
     [](PairHit &h) {
         meetAt(h, h.meeting.sum() / std::max(std::abs(h.normal.x), std::abs(h.normal.y)));
     }},
    {"by x alone",
     [](PairHit &h) { meetAt(h, h.meeting.sum() / std::max(0.1, std::abs(h.normal.x))); }},
    {"by the sum of both ways",
     [](PairHit &h) {
         meetAt(h, h.meeting.sum() / (std::abs(h.normal.x) + std::abs(h.normal.y)));
     }},
    {"by y alone",
     [](PairHit &h) { meetAt(h, h.meeting.sum() / std::max(0.02, std::abs(h.normal.y))); }},
    {"sum of the squares",
     [](PairHit &h) { meetAt(h, std::hypot(h.meeting.radius1, h.meeting.radius2)); }},
    {"mean of the product",
     [](PairHit &h) { meetAt(h, 2.0 * std::sqrt(h.meeting.radius1 * h.meeting.radius2)); }},
    {"diameters", [](PairHit &h) { meetAt(h, 2.0 * h.meeting.sum()); }},
    {"half of the sum", [](PairHit &h) { meetAt(h, 0.5 * h.meeting.sum()); }},
    {"smaller radius twice",
     [](PairHit &h) { meetAt(h, 2.0 * std::min(h.meeting.radius1, h.meeting.radius2)); }},
    {"larger radius",
     [](PairHit &h) { meetAt(h, std::max(h.meeting.radius1, h.meeting.radius2)); }},
    {"a number beside radius 1", [](PairHit &h) { meetAt(h, h.meeting.radius1 + 0.3); }},
    {"a number beside radius 2", [](PairHit &h) { meetAt(h, h.meeting.radius2 + 0.2); }},
    {"distance squared", [](PairHit &h) { meetAt(h, std::sqrt(h.meeting.sum())); }},
    {"square of the sum", [](PairHit &h) { meetAt(h, h.meeting.sum() * h.meeting.sum()); }},
    {"radius by density",
     [](PairHit &h) { meetAt(h, h.meeting.sum() * h.meeting.density1 / 7.8); }},
    {"only to the right", [](PairHit &h) { h.answered = h.normal.x > 0.0; }},
    {"only slow ones", [](PairHit &h) { h.answered = dot(h.came1 - h.came2, h.normal) < 1.0; }},
    {"only moving ones", [](PairHit &h) { h.answered = length(h.came2) > 1e-9; }},
    {"once they part", [](PairHit &h) { h.parting = true; }},
    {"late", [](PairHit &h) { h.late = true; }},
};

} // namespace cradle::approved
