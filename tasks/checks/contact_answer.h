// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/contacts.h"

#include <utility>

namespace cradle {

/// One contact with the circles and the laws that may answer it.
struct ContactAnswer {
    const Observation &o;
    int a;
    int b;
    const motion::Contact &contact;
    double restitution; ///< that is right
    double tolerance;   ///< m/s, times 1 + speed

    /// Whether the velocities became what \p law makes of them, within the tolerance.
    [[nodiscard]] bool follows(CircleLaw law) const;
    /// What the velocities of a and b would be after the contact by \p law and the normal \p n.
    [[nodiscard]] std::pair<Vec2, Vec2> expected(CircleLaw law, Vec2 n) const;
    /// The normal that the program took if it is honest, else that of the middle of the step.
    [[nodiscard]] Vec2 normal() const;
    /// That of the middle of the step.
    [[nodiscard]] Vec2 middleNormal() const;
    /// How fast they came nearer, m/s; negative if they were moving apart.
    [[nodiscard]] double approach() const;
    /// What the contact took from the velocities after it, m/s².
    [[nodiscard]] Vec2 gravity() const;

private:
    [[nodiscard]] Vec2 usedNormal() const;
    [[nodiscard]] bool isHonest(Vec2 n) const;
};

} // namespace cradle
