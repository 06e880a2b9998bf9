// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

#include <vector>

/// What an observation tells of the contacts of two circles.
namespace cradle::motion {

/// A contact of circles 1 and 2 that changed a velocity.
struct Contact {
    qint64 step = 0; ///< the velocities of the next state are the changed ones
    Vec2 beforeA{};  ///< without the step's gravity, m/s
    Vec2 beforeB{};
    Vec2 afterA{};
    Vec2 afterB{};
    double nearest = 0.0; ///< least distance of the rims that a program may see in the step, m
    Vec2 normalFirst{};   ///< the first and the last normal that is honest with discrete steps
    Vec2 normalLast{};
    Vec2 normalA{}; ///< when a has made its step and b has not: one is moved after the other
    Vec2 normalB{};
};

/// The contacts of circles \p a and \p b, oldest first, walls left out.
[[nodiscard]] std::vector<Contact> contactsOf(const Observation &o, int a, int b, Vec2 gravity);

/// What is wrong with the motion of \p a or \p b in every step, of which no hit must be blamed.
[[nodiscard]] std::optional<Fault> steadyFaultOf(const Observation &o, int a, int b, Vec2 gravity);

/// Whether a wall may push \p a or \p b in the step of their \p contact, too.
[[nodiscard]] bool isBesideWall(const Observation &o, int a, int b, const Contact &contact,
                                Vec2 gravity);

/// The first step at which both have been inside each other, still coming nearer, for longer than
/// an honest program needs to see it; −1 if there is none.
[[nodiscard]] qint64 missedContact(const Observation &o, int a, int b);

/// Whether a hit of \p a and \p b ever leaves them inside each other while they part. Only then
/// does it show whether a program asks if they approach.
[[nodiscard]] bool leavesInside(const Observation &o, int a, int b, Vec2 gravity);

} // namespace cradle::motion
