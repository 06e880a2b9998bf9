// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/programs.h"

/// How programs answer the contact of two circles, right and wrong.
namespace cradle::programs::contacts {

inline constexpr double mistakenRestitution = 0.5; ///< that the mistakes run with

inline double reach(const Circles &c)
{
    return c[0].radius + c[1].radius;
}

inline Vec2 between(const Circles &c)
{
    return c[1].position - c[0].position;
}

inline void move(Circles &c, double h)
{
    for (Circle &each : c)
        each.position += h * each.velocity;
}

/// v' = v ± J/m with e; only if they come nearer.
inline void push(Circles &c, Vec2 n, double e)
{
    const double closing = dot(c[0].velocity - c[1].velocity, n);
    if (closing <= 0.0)
        return;
    const double m0 = mass(c[0]);
    const double m1 = mass(c[1]);
    const double impulse = (1.0 + e) * closing * m0 * m1 / (m0 + m1);
    c[0].velocity -= impulse / m0 * n;
    c[1].velocity += impulse / m1 * n;
}

inline bool touches(const Circles &c)
{
    return length(between(c)) < reach(c);
}

using Step = void (*)(Circles &c, double e, double h);

struct Way {
    const char *name;
    Step step;
};

inline constexpr Way rightWays[] = {{"goes back, normal of the step before",
                                     [](Circles &c, double e, double h) {
                                         const Circles old = c;
                                         move(c, h);
                                         if (!touches(c))
                                             return;
                                         push(c, normalized(between(old)), e);
                                         c[0].position = old[0].position;
                                         c[1].position = old[1].position;
                                     }},
                                    {"goes back, normal of the hit",
                                     [](Circles &c, double e, double h) {
                                         const Circles old = c;
                                         move(c, h);
                                         if (!touches(c))
                                             return;
                                         push(c, normalized(between(c)), e);
                                         c[0].position = old[0].position;
                                         c[1].position = old[1].position;
                                     }},
                                    {"stays inside and separates",
                                     [](Circles &c, double e, double h) {
                                         move(c, h);
                                         if (touches(c))
                                             push(c, normalized(between(c)), e);
                                     }},
                                    {"pushes the circles apart",
                                     [](Circles &c, double e, double h) {
                                         move(c, h);
                                         if (!touches(c))
                                             return;
                                         const Vec2 n = normalized(between(c));
                                         push(c, n, e);
                                         const double depth = reach(c) - length(between(c));
                                         c[0].position -= 0.5 * depth * n;
                                         c[1].position += 0.5 * depth * n;
                                     }},
                                    {"looks before it moves", [](Circles &c, double e, double h) {
                                         if (touches(c))
                                             push(c, normalized(between(c)), e);
                                         move(c, h);
                                     }}};

struct Mistake {
    const char *name;
    const char *word; ///< of the message
    Step step;
    double degrees = 30.0;
};

/// Moves, and on a hit answers by \p answer, from the old positions.
template <typename Answer>
void onHit(Circles &c, double h, const Answer &answer)
{
    const Circles old = c;
    move(c, h);
    if (!touches(c))
        return;
    answer(c, normalized(between(old)));
    c[0].position = old[0].position;
    c[1].position = old[1].position;
}

/// Moves, and on a hit answers rightly and moves the circles by \p part, which knows how deep they
/// are in each other.
template <typename Part>
void onTouch(Circles &c, double h, double e, const Part &part)
{
    move(c, h);
    if (!touches(c))
        return;
    const Vec2 n = normalized(between(c));
    const double depth = reach(c) - length(between(c));
    push(c, n, e);
    part(c, n, depth);
}

inline constexpr Mistake mistakes[] = {
    {"whole velocity reversed", "left the hit",
     [](Circles &c, double, double h) {
         onHit(c, h, [](Circles &d, Vec2) {
             for (Circle &each : d)
                 each.velocity = -each.velocity;
         });
     }},
    {"whole velocities swapped", "left the hit",
     [](Circles &c, double, double h) {
         onHit(c, h, [](Circles &d, Vec2) { std::swap(d[0].velocity, d[1].velocity); });
     }},
    {"normal not normalised", "left the hit",
     [](Circles &c, double e, double h) {
         onHit(c, h, [e](Circles &d, Vec2) { push(d, between(d), e); });
     }},
    {"normal the wrong way round", "run into each other",
     [](Circles &c, double e, double h) {
         onHit(c, h, [e](Circles &d, Vec2 n) { push(d, -n, e); });
         if (touches(c))
             return;
         const Circles old = c;
         move(c, h);
         if (!touches(c))
             c = old;
     }},
    {"second velocity from the changed first", "left the hit",
     [](Circles &c, double e, double h) {
         onHit(c, h, [e](Circles &d, Vec2 n) {
             const double share = (1.0 + e) / 2.0;
             d[0].velocity -= share * dot(d[0].velocity - d[1].velocity, n) * n;
             d[1].velocity += share * dot(d[0].velocity - d[1].velocity, n) * n;
         });
     }},
    {"e twice", "left the hit",
     [](Circles &c, double e, double h) {
         onHit(c, h, [e](Circles &d, Vec2 n) { push(d, n, e * e); });
     }},
    {"e on one circle only", "left the hit",
     [](Circles &c, double e, double h) {
         onHit(c, h, [e](Circles &d, Vec2 n) {
             const Vec2 second = d[1].velocity;
             push(d, n, e);
             const Vec2 change = d[1].velocity - second;
             d[1].velocity = second + 2.0 / (1.0 + e) * change;
         });
     }},
    {"margin", "from whose rim",
     [](Circles &c, double e, double h) {
         c[0].radius += 0.05;
         onHit(c, h, [e](Circles &d, Vec2 n) { push(d, n, e); });
         c[0].radius -= 0.05;
     }},
    {"one radius only", "run into each other",
     [](Circles &c, double e, double h) {
         const double radius = c[1].radius;
         c[1].radius = 0.0;
         onHit(c, h, [e](Circles &d, Vec2 n) { push(d, n, e); });
         c[1].radius = radius;
     }},
    {"boxes instead of circles", "from whose rim",
     [](Circles &c, double e, double h) {
         const Vec2 d = between(c);
         if (std::abs(d.x) < reach(c) && std::abs(d.y) < reach(c))
             push(c, normalized(d), e);
         move(c, h);
     },
     45.0},
    {"no reaction", "run into each other", [](Circles &c, double, double h) { move(c, h); }},
    {"both in one place", "m at once",
     [](Circles &c, double e, double h) {
         const Vec2 place = c[0].position;
         onHit(c, h, [e](Circles &d, Vec2 n) { push(d, n, e); });
         if (c[0].position == place)
             c[1].position = place;
     }},
    {"pushed into each other", "nearer to the other one",
     [](Circles &c, double e, double h) {
         onTouch(c, h, e, [](Circles &d, Vec2 n, double depth) {
             d[0].position += 0.5 * depth * n;
             d[1].position -= 0.5 * depth * n;
         });
     }},
    {"goes back with the other's velocity", "the hit put circle 1",
     [](Circles &c, double e, double h) {
         const Vec2 first = c[0].velocity;
         const Vec2 second = c[1].velocity;
         onTouch(c, h, e, [&](Circles &d, Vec2, double) {
             d[0].position -= h * second;
             d[1].position -= h * first;
         });
     }},
    {"pushed aside", "to the side",
     [](Circles &c, double e, double h) {
         onTouch(c, h, e, [](Circles &d, Vec2 n, double depth) {
             d[0].position -= 10.0 * depth * perpendicular(n);
         });
     }},
    {"pushed too far apart", "farther from the other one",
     [](Circles &c, double e, double h) {
         onTouch(c, h, e,
                 [](Circles &d, Vec2 n, double depth) { d[1].position += 5.0 * depth * n; });
     }},
    {"hit again while separating", "moving apart", [](Circles &c, double, double h) {
         move(c, h);
         if (!touches(c))
             return;
         const Vec2 n = normalized(between(c));
         const double closing = dot(c[0].velocity - c[1].velocity, n);
         c[0].velocity -= (1.0 + mistakenRestitution) / 2.0 * closing * n;
         c[1].velocity += (1.0 + mistakenRestitution) / 2.0 * closing * n;
     }}};

} // namespace cradle::programs::contacts
