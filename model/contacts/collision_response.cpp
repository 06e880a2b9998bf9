// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/collision_response.h"

#include <utility>

namespace cradle {

bool respond(CircleLaw law, Circle &a, Circle &b, Vec2 n, double restitution)
{
    const double closing = dot(a.velocity - b.velocity, n);
    if (law == CircleLaw::None || closing <= 0.0)
        return false;
    switch (law) {
    case CircleLaw::None:
        break;
    case CircleLaw::Stop:
        a.velocity = b.velocity = Vec2{};
        break;
    case CircleLaw::SwapVelocities:
        std::swap(a.velocity, b.velocity);
        break;
    case CircleLaw::SwapNormal:
        a.velocity -= closing * n;
        b.velocity += closing * n;
        break;
    case CircleLaw::Impulse: {
        const double reduced = mass(a) / (mass(a) + mass(b)) * mass(b);
        const Vec2 impulse = (1.0 + restitution) * reduced * closing * n;
        a.velocity -= impulse / mass(a);
        b.velocity += impulse / mass(b);
        break;
    }
    }
    return true;
}

bool reflect(Vec2 &velocity, Vec2 n, double restitution)
{
    const double into = dot(velocity, n);
    if (into <= 0.0)
        return false;
    velocity -= (1.0 + restitution) * into * n;
    return true;
}

} // namespace cradle
