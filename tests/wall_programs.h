// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/programs.h"
#include "tests/scenes.h"

/// How programs answer a wall, right and wrong.
namespace cradle::programs::walls {

inline constexpr double wall = scenes::halfWidth;
inline constexpr Vec2 down{0.0, -scenes::g};

/// Calls \p hit with a component of position and velocity for each wall that the rim is beyond.
inline void atWalls(Circle &c, const std::function<void(double &x, double &v, double side)> &hit)
{
    for (const double side : {-1.0, 1.0}) {
        if (side * c.position.x + c.radius > wall)
            hit(c.position.x, c.velocity.x, side);
        if (side * c.position.y + c.radius > wall)
            hit(c.position.y, c.velocity.y, side);
    }
}

struct Way {
    const char *name;
    void (*step)(Circle &c, Vec2 gravity, double e, double h);
};

inline void goBack(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    fall(c, gravity, h);
    bool back = false;
    atWalls(c, [&](double &, double &v, double side) {
        back = true;
        if (v * side > 0.0)
            v *= -e;
    });
    if (back)
        c.position = old;
}

inline void clamp(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    const double reach = wall - c.radius;
    atWalls(c, [&](double &x, double &v, double side) {
        x = side * reach;
        if (v * side > 0.0)
            v *= -e;
    });
}

inline void mirror(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    const double reach = wall - c.radius;
    atWalls(c, [&](double &x, double &v, double side) {
        x = side * reach - e * (x - side * reach);
        if (v * side > 0.0)
            v *= -e;
    });
}

/// Looks before it moves: the hit shows one step late.
inline void lookFirst(Circle &c, Vec2 gravity, double e, double h)
{
    atWalls(c, [&](double &, double &v, double side) {
        if (v * side > 0.0)
            v *= -e;
    });
    fall(c, gravity, h);
}

/// Velocity turned round after the position was carried on (Euler).
inline void eulerGoBack(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    c.position += h * c.velocity;
    bool back = false;
    atWalls(c, [&](double &, double &v, double side) {
        back = true;
        if (v * side > 0.0)
            v *= -e;
    });
    c.velocity += h * gravity;
    if (back)
        c.position = old;
}

inline constexpr Way rightWays[] = {{"goes back", goBack},
                                    {"clamps", clamp},
                                    {"mirrors the overshoot", mirror},
                                    {"looks before it moves", lookFirst},
                                    {"Euler, goes back", eulerGoBack}};

// The known mistakes, each a change of a right program.

inline void wholeVelocity(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    fall(c, gravity, h);
    bool hit = false;
    atWalls(c, [&](double &, double &, double) { hit = true; });
    if (hit) {
        c.position = old;
        c.velocity = -e * c.velocity;
    }
}

inline void twoWalls(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    if (std::abs(c.position.x) + c.radius > wall && c.position.x * c.velocity.x > 0.0)
        c.velocity.x *= -e;
}

inline void centre(Circle &c, Vec2 gravity, double e, double h)
{
    const double radius = c.radius;
    c.radius = 0.0;
    goBack(c, gravity, e, h);
    c.radius = radius;
}

inline void margin(Circle &c, Vec2 gravity, double e, double h)
{
    c.radius += 0.1;
    goBack(c, gravity, e, h);
    c.radius -= 0.1;
}

/// Turns round at every step beyond the wall: with e < 1 it never comes out again.
inline void stuck(Circle &c, Vec2 gravity, double e, double h)
{
    fall(c, gravity, h);
    atWalls(c, [&](double &, double &v, double) { v *= -e; });
}

inline void twiceRestitution(Circle &c, Vec2 gravity, double e, double h)
{
    goBack(c, gravity, e * e, h);
}

inline void restitutionOnBothParts(Circle &c, Vec2 gravity, double e, double h)
{
    const Vec2 old = c.position;
    fall(c, gravity, h);
    atWalls(c, [&](double &, double &v, double side) {
        if (v * side > 0.0) {
            v = -v;
            c.velocity = e * c.velocity;
        }
        c.position = old;
    });
}

inline void absorbed(Circle &c, Vec2 gravity, double, double h)
{
    goBack(c, gravity, 0.0, h);
}

/// The right-hand wall sends back what leaves it, too.
inline void turnedBack(Circle &c, Vec2 gravity, double e, double h)
{
    const bool leaves = c.velocity.x < 0.0;
    goBack(c, gravity, e, h);
    if (leaves && c.position.x > wall - 2.0 * c.radius)
        c.velocity.x = -c.velocity.x;
}

/// Right, but put 10 cm too far in.
inline void gap(Circle &c, Vec2 gravity, double e, double h)
{
    clamp(c, gravity, e, h);
    const double reach = wall - c.radius;
    for (double Vec2::*part : {&Vec2::x, &Vec2::y}) {
        if (std::abs(c.position.*part) == reach)
            c.position.*part *= (reach - 0.1) / reach;
    }
}

/// Right, but a wall at the side puts it 10 cm lower.
inline void slide(Circle &c, Vec2 gravity, double e, double h)
{
    const double before = c.velocity.x;
    mirror(c, gravity, e, h);
    if (before * c.velocity.x < 0.0)
        c.position.y -= 0.1;
}

inline constexpr Way mistakes[] = {{"whole velocity turned", wholeVelocity},
                                   {"only two walls", twoWalls},
                                   {"centre instead of rim", centre},
                                   {"margin", margin},
                                   {"stuck in the wall", stuck},
                                   {"e twice", twiceRestitution},
                                   {"e along the wall, too", restitutionOnBothParts},
                                   {"no rebound", absorbed},
                                   {"turned back as it leaves", turnedBack},
                                   {"a gap at the wall", gap},
                                   {"moved along the wall", slide}};

} // namespace cradle::programs::walls
